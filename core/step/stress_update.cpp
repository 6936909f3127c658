#include "core/step/stress_update.hpp"

#include "core/base/pack_matrix.hpp"
#include "core/base/parallel.hpp"
#include "core/step/block_motion.hpp"
#include "core/step/law_failure.hpp"
#include "core/step/polar_rotation.hpp"

#include <numbers>
#include <numeric>

namespace riedel {

namespace {

constexpr Index law_block = 64; ///< points passed to a law at once: their columns stay in the nearest cache
static_assert(block_size % law_block == 0);

/// W_32, W_13, W_21 of eight points, in the plane only W_12 [1/s].
template <int Dim>
auto spin_of(const Columns& L, Index p) {
  const auto w = [&](int i, int j) {
    return Pack(0.5) * (Pack::load(L[i * Dim + j] + p) - Pack::load(L[j * Dim + i] + p));
  };
  if constexpr (Dim == 2)
    return w(0, 1);
  else
    return std::array<Pack, 3>{w(2, 1), w(0, 2), w(1, 0)};
}

/// Q of the step for eight points.
template <ObjectiveRate objective, int Dim>
auto rotation_of_step(const Points<Dim>& points, Index p, double dt) {
  if constexpr (objective == ObjectiveRate::jaumann)
    return cayley(spin_of<Dim>(points.velocity_gradient, p), dt);
  else
    return polar_rotation(load_matrix<Dim>(points.deformation_gradient, p),
                          load_matrix<Dim>(points.velocity_gradient, p), dt);
}

/// Mandel components affected by a motion in Dim dimensions: in the plane 11, 22 and 12.
template <int Dim>
constexpr auto components_of_motion = [] {
  if constexpr (Dim == 2)
    return std::array{0, 1, 3};
  else
    return std::array{0, 1, 2, 3, 4, 5};
}();

/// Columns of a block of points as passed to a law; lives on the stack. Columns are padded to whole packs.
template <int Dim>
class LawBlock {
public:
  /// @param time at the start of the step [s]   @param step taken before this one
  LawBlock(Points<Dim>& points, const Material& law, double time, std::int64_t step, double dt) : points_(points) {
    batch_.time = batch_.stage_time = time;
    batch_.increment = step + 1;
    batch_.time_step = dt;
    if (law.follows_motion()) batch_.motion = &motion_.motion();
    for (int c = 0; c < 6; ++c) batch_.rate[c] = D_[c].data();
  }
  const MaterialBatch& batch() const { return batch_; }

  void move_to(Range range) {
    range_ = range;
    batch_.size = range.size();
    for (int c = 0; c < 6; ++c) batch_.stress[c] = points_.stress[c] + range.begin;
    for (int s = 0; s < points_.state.components(); ++s) state_[s] = points_.state[s] + range.begin;
    batch_.state = {state_.data(), static_cast<std::size_t>(points_.state.components())};
    batch_.id = points_.id.data() + range.begin;
  }
  /// For a law that follows the motion.
  template <ObjectiveRate objective>
  void follow_motion() {
    if (batch_.motion == nullptr) return;
    motion_.follow(points_, range_, batch_.time_step,
                   [&](Index p) { return rotation_of_step<objective>(points_, p, batch_.time_step); });
  }
  void take_average(const double* averaged) { batch_.averaged = averaged ? averaged + range_.begin : nullptr; }

  /// Rotates the stress and computes the rates of deformation. @return Σ V σ:D of the rotated stress [W or W/m], half
  /// of which over the step is added to the work of each point
  template <ObjectiveRate objective>
  double rotate_and_fill_rates() {
    const Columns& L = points_.velocity_gradient;
    return sum_over_packs([&](Index p, Index i) {
      Sym<Pack> stress = Sym<Pack>::zero();
      for (const int c : components_of_motion<Dim>) stress.m[c] = Pack::load(points_.stress[c] + p);
      rotate(stress, rotation_of_step<objective>(points_, p, batch_.time_step));
      Pack density(0.0);
      for (int a = 0; a < Dim; ++a)
        for (int b = 0; b <= a; ++b) {
          const int c = a == b ? a : a + b + 2;
          const Pack d = a == b ? Pack::load(L[a * Dim + a] + p)
                                : Pack(std::numbers::sqrt2 / 2) *
                                      (Pack::load(L[a * Dim + b] + p) + Pack::load(L[b * Dim + a] + p));
          d.store(D_[c].data() + i);
          stress.m[c].store(points_.stress[c] + p);
          density += stress.m[c] * d;
        }
      return add_to_work(p, density);
    });
  }
  /// The same with the present stress.
  double power() {
    return sum_over_packs([&](Index p, Index i) {
      Pack density(0.0);
      for (const int c : components_of_motion<Dim>)
        density += Pack::load(points_.stress[c] + p) * Pack::load(D_[c].data() + i);
      return add_to_work(p, density);
    });
  }

  void fail_where_not_finite(MaterialReport& report) const {
    for (Index p = range_.begin; p < range_.end; ++p)
      for (int c = 0; c < 6; ++c)
        if (!std::isfinite(points_.stress[c][p])) {
          report.fail(p - range_.begin, "it returned a stress that is not finite");
          break;
        }
  }

private:
  /// @param density σ:D of eight points [W/m³]   @return V σ:D
  Pack add_to_work(Index p, const Pack& density) {
    const Pack power = Pack::load(points_.volume[0] + p) * density;
    double* const work = points_.work[0] + p;
    (Pack::load(work) + Pack(0.5 * batch_.time_step) * power).store(work);
    return power;
  }

  /// Σ of `part(p, i)`, p the first of eight points and i its position in the block; padded points have no volume.
  template <class Part>
  double sum_over_packs(const Part& part) const {
    Pack sum(0.0);
    for (Index p = range_.begin, i = 0; p < range_.end; p += pack_size, i += pack_size) sum += part(p, i);
    alignas(64) std::array<double, pack_size> lane;
    sum.store(lane.data());
    return std::accumulate(lane.begin(), lane.end(), 0.0);
  }

  Points<Dim>& points_;
  Range range_;
  std::array<std::array<double, law_block>, 6> D_{}; ///< components absent in plane motion stay zero
  std::array<double*, max_state_columns> state_{};
  BlockMotion<Dim, law_block> motion_;
  MaterialBatch batch_;
};

/// Rotates the tensors among the law's state variables with the material.
template <ObjectiveRate objective, int Dim>
void rotate_state(Body<Dim>& body, Range range, double dt) {
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    for (Index p = range.begin; variable.components == 6 && p < range.end; p += pack_size) {
      Sym<Pack> a;
      for (int c = 0; c < 6; ++c) a.m[c] = Pack::load(body.points.state[column + c] + p);
      rotate(a, rotation_of_step<objective>(body.points, p, dt));
      for (int c = 0; c < 6; ++c) a.m[c].store(body.points.state[column + c] + p);
    }
    column += variable.components;
  }
}

/// Rotation and law over a range of points.
template <ObjectiveRate objective, int Dim>
BlockResult update_range(State<Dim>& state, Body<Dim>& body, Range whole, const double* averaged, double dt) {
  BlockResult share;
  LawBlock<Dim> block(body.points, *body.material, state.time, state.step, dt);
  rotate_state<objective>(body, whole, dt);
  for (Index b = whole.begin; b < whole.end; b += law_block) {
    block.move_to({b, std::min(b + law_block, whole.end)});
    block.take_average(averaged);
    block.template follow_motion<objective>();
    MaterialReport report;
    const double before = block.template rotate_and_fill_rates<objective>();
    body.material->integrate(block.batch(), report);
    const double after = block.power();
    if (!std::isfinite(after)) block.fail_where_not_finite(report);
    share.report.add(report, b);
    share.work += 0.5 * dt * (before + after);
  }
  return share;
}

template <int Dim>
const double* average(State<Dim>& state, Body<Dim>& body) {
  if (!body.averager) return nullptr;
  Points<Dim>& points = body.points;
  const double* field = body.averaged_state < 0 ? points.rate_norm[0] : points.state[body.averaged_state];
  {
    const PhaseClock::Lap lap(state.clock, Phase::neighbours);
    body.averager->update_neighbours(points.position);
  }
  const PhaseClock::Lap lap(state.clock, Phase::averaging);
  body.averager->average(points.volume[0], field, points.averaged[0]);
  return points.averaged[0];
}

} // namespace

template <int Dim>
void update_stress(State<Dim>& state, const Model<Dim>& model, double dt) {
  const auto update = model.objective_rate == ObjectiveRate::jaumann ? update_range<ObjectiveRate::jaumann, Dim>
                                                                     : update_range<ObjectiveRate::green_naghdi, Dim>;
  for (Body<Dim>& body : state.bodies) {
    const double* averaged = average(state, body);
    const PhaseClock::Lap lap(state.clock, Phase::law);
    const auto add = [](BlockResult sum, const BlockResult& share) {
      sum.report.add(share.report, 0);
      sum.work += share.work;
      return sum;
    };
    const BlockResult all = watched(state, body, [&] {
      return reduce_blocks(
          body.points.size(), state.block_results, BlockResult{},
          [&](Range range) { return update(state, body, range, averaged, dt); }, add);
    });
    if (all.report.failures > 0) report_failure(state, body, all.report);
    state.report.add(all.report, 0);
    state.internal_work += all.work;
  }
}

template <int Dim>
MaterialLimits assess(Body<Dim>& body, std::vector<MaterialLimits>& parts, double time, std::int64_t step) {
  return reduce_blocks(
      body.points.size(), parts, MaterialLimits{},
      [&](Range range) {
        MaterialLimits found;
        LawBlock<Dim> block(body.points, *body.material, time, step, 0.0);
        for (Index b = range.begin; b < range.end; b += law_block) {
          block.move_to({b, std::min(b + law_block, range.end)});
          block.template follow_motion<ObjectiveRate::jaumann>(); // no rotation
          found.add(body.material->assess(block.batch()));
        }
        return found;
      },
      [](MaterialLimits all, const MaterialLimits& part) {
        all.add(part);
        return all;
      });
}

template void update_stress<2>(State<2>&, const Model<2>&, double);
template void update_stress<3>(State<3>&, const Model<3>&, double);
template MaterialLimits assess<2>(Body<2>&, std::vector<MaterialLimits>&, double, std::int64_t);
template MaterialLimits assess<3>(Body<3>&, std::vector<MaterialLimits>&, double, std::int64_t);

} // namespace riedel
