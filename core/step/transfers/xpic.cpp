#include "core/step/transfers/xpic.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/gather.hpp"
#include "core/step/kernels/scatter.hpp"

namespace riedel {

namespace {

/// (mv)_i = Σ_p N_ip m_p Σ_j N_jp t_j: once to the points and back.
template <int Dim>
void send_there_and_back(State<Dim>& state, const Model<Dim>& model) {
  parallel_for(state.nodes.size(), [&](Index i) { state.nodes.sums[i].momentum.setZero(); });
  for (Body<Dim>& body : state.bodies)
    add_in_slab_order<Shares<Dim>>(state, model, body, [&](const SlabGroup<Dim>& group, Shares<Dim>& shares) {
      Gathered<Dim> sum;
      gather<Use::values>(group.stencil, state.nodes.filter, sum);
      const std::array<Pack, 4> t = sum.motion.front().columns();
      const Pack m = Pack::load(body.points.mass[0] + group.first);
      std::array<Pack, 4> momenta; // without mass, which the nodes have already
      momenta.fill(Pack(0.0));
      for (int a = 0; a < Dim; ++a) momenta[a] = m * t[a];
      shares.mass.put(momenta);
      scatter<Use::values>(group, shares, state.nodes);
    });
}

} // namespace

/// (I − (I − SS⁺)ᵐ) V = S u with u = Σ_k t_k, t_1 = S⁺V, t_{k+1} = (I − S⁺S) t_k, k up to m: the same as the paper's
/// sum of binomials times (S⁺S)ᵏ S⁺V, by differences, which are small. t stands in the place of a velocity, u in that
/// of an acceleration.
template <int Dim>
void filter_velocities(State<Dim>& state, const Model<Dim>& model) {
  if (model.transfer != VelocityTransfer::xpic) return;
  const PhaseClock::Lap lap(state.clock, Phase::g2p);
  AlignedVector<NodeMotion<Dim>>& filter = state.nodes.filter;
  const auto mean = [&](Index i) -> Vec<Dim> {
    const NodeSums<Dim>& sums = state.nodes.sums[i];
    return sums.mass > 0.0 ? Vec<Dim>(sums.momentum * (1.0 / sums.mass)) : Vec<Dim>(Vec<Dim>::Zero());
  };
  parallel_for(state.nodes.size(), [&](Index i) { filter[i].velocity = filter[i].acceleration = mean(i); });
  for (int k = 1; k < model.xpic_order; ++k) {
    send_there_and_back(state, model);
    parallel_for(state.nodes.size(), [&](Index i) {
      filter[i].velocity -= mean(i);
      filter[i].acceleration += filter[i].velocity;
    });
  }
  for_each_group(state, model, [&](Body<Dim>& body, const StencilGroup<Dim>& stencil, Index p) {
    Gathered<Dim> sum;
    gather<Use::values>(stencil, filter, sum);
    const std::array<Pack, 4> u = sum.motion.back().columns();
    for (int a = 0; a < Dim; ++a) u[Dim == 2 ? 2 + a : a].store(body.points.velocity[a] + p);
  });
}

template void filter_velocities<2>(State<2>&, const Model<2>&);
template void filter_velocities<3>(State<3>&, const Model<3>&);

} // namespace riedel
