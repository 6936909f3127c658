#include "transfers/xpic.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_contributions.hpp"

namespace riedel {

namespace {

/// (mv)_i = Σ_p N_ip m_p Σ_j N_jp t_j: one mapping to the points and back.
template <int Dim>
void send_there_and_back(State<Dim>& state, const Model<Dim>& model, const AlignedVector<NodeMotion<Dim>>& t) {
  clear_momentum(state.nodes);
  for (Body<Dim>& body : state.bodies)
    add_in_slab_order<PointContributions<Dim>>(
        state, model, body, [&](const SlabGroup<Dim>& group, PointContributions<Dim>& contributions) {
          Gathered<Dim> sum;
          gather<Use::weights>(group.stencil, t, sum);
          const std::array<Pack, 4> of_points = sum.motion.front().columns();
          std::array<Pack, Dim> velocity;
          std::copy_n(of_points.begin(), Dim, velocity.begin());
          contributions.mass.put(momenta<Dim>(body.points, group.first, velocity));
          scatter<Use::weights>(group, contributions, state.nodes);
        });
}

} // namespace

template <int Dim>
Keys Xpic<Dim>::parameters() {
  return {{"xpic_order", std::int64_t{2}, "-", between(1, 40), "m of XPIC(m), 1 is PIC"}};
}

template <int Dim>
Xpic<Dim>::Xpic(const Values& options)
    : Update(Blend<Dim>{.flip = 1.0}), order_(static_cast<int>(options.integer("xpic_order"))) {}

/// (I − (I − SS⁺)ᵐ) V = S u with u = Σ_k t_k, t_1 = S⁺V, t_{k+1} = (I − S⁺S) t_k, k up to m: the same as the paper's
/// sum of binomials times (S⁺S)ᵏ S⁺V, by small differences. t is stored as a velocity, u as an acceleration.
template <int Dim>
void Xpic<Dim>::filter_velocities(State<Dim>& state, const Model<Dim>& model) const {
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  AlignedVector<NodeMotion<Dim>>& filter = state.transfer_room.nodes.front();
  const auto mean = [&](Index i) -> Vec<Dim> {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    return sums.mass > 0.0 ? Vec<Dim>(sums.momentum * (1.0 / sums.mass)) : Vec<Dim>(Vec<Dim>::Zero());
  };
  parallel_for(state.nodes.size(), [&](Index i) { filter[i].velocity = filter[i].acceleration = mean(i); });
  for (int k = 1; k < order_; ++k) {
    send_there_and_back(state, model, filter);
    parallel_for(state.nodes.size(), [&](Index i) {
      filter[i].velocity -= mean(i);
      filter[i].acceleration += filter[i].velocity;
    });
  }
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    gather<Use::weights>(stencil, filter, sum);
    const std::array<Pack, 4> u = sum.motion.back().columns();
    for (int a = 0; a < Dim; ++a) u[Dim == 2 ? 2 + a : a].store(body.points.velocity[a] + p);
  });
}

template <int Dim>
void Xpic<Dim>::move_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  filter_velocities(state, model);
  Update::move_points(state, model, dt);
}

template <int Dim>
void Xpic<Dim>::grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const {
  filter_velocities(state, model);
  Update::grid_to_points(state, model, dt);
}

template <int Dim>
void Xpic<Dim>::remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const {
  filter_velocities(state, model);
  Update::remap_velocity(state, model, dt);
}

template class Xpic<2>;
template class Xpic<3>;

} // namespace riedel
