#include "core/step/stress_filter.hpp"

#include "core/step/smoothing.hpp"

namespace riedel {

namespace {

constexpr int components = 6, volume_at = 6; ///< number of stress lanes, and lane of ln J

/// Stress components, and ln J.
template <int Dim>
void fill_fields(Body<Dim>& body) {
  const Points<Dim>& points = body.points;
  for_each_block(points.size(), [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      ShortVector<8> row(0.0);
      for (int c = 0; c < components; ++c) row.lanes[c] = points.stress[c][p];
      row.lanes[volume_at] = std::log(points.volume[0][p] / points.initial_volume[0][p]);
      body.fields[p] = row;
    }
  });
}

/// A stress-free point, out of contact with its neighbours, gets no stress from them.
template <int Dim>
bool carries_stress(const Points<Dim>& points, Index p) {
  for (int c = 0; c < components; ++c)
    if (points.stress[c][p] != 0.0) return true;
  return false;
}

template <int Dim>
void use_fields(Body<Dim>& body, const StressFilter& filter, double dt) {
  Points<Dim>& points = body.points;
  const double span = filter.steps_between * dt; // exponentials are safe for rates above one per span
  const double of_stress = -std::expm1(-filter.stress_rate * span), of_volume = -std::expm1(-filter.volume_rate * span);
  for_each_block(points.size(), [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      const ShortVector<8>& rest = body.fields[p];
      points.expansion[0][p] = -of_volume / span * rest.lanes[volume_at];
      if (carries_stress(points, p))
        for (int c = 0; c < components; ++c) points.stress[c][p] -= of_stress * rest.lanes[c];
    }
  });
}

/// Power of the added strain rates, Σ V σ:ΔD [W or W/m].
template <int Dim>
double added_power(const Points<Dim>& points, int axes, Range block) {
  double power = 0.0;
  for (Index p = block.begin; p < block.end; ++p) {
    double trace = 0.0;
    for (int a = 0; a < axes; ++a) trace += points.stress[a][p];
    power += points.volume[0][p] * trace * points.expansion[0][p] / axes;
  }
  return power;
}

} // namespace

template <int Dim>
void filter_stresses(State<Dim>& state, const Model<Dim>& model, double dt) {
  const StressFilter& filter = model.stress_filter;
  if (!filter.on()) return;
  const PhaseClock::Lap lap(state.clock, Phase::filter);
  const bool now = state.step % filter.steps_between == 0;
  for (Body<Dim>& body : state.bodies) {
    if (now) {
      body.stencils.keep_for_this_step(*model.scheme, state.grid, body.points, state.clock);
      fill_fields(body);
      subtract_linear(state, body);
      subtract_smooth(state, model, body, filter.order);
      subtract_linear(state, body);
      use_fields(body, filter, dt);
    }
    state.filter_work +=
        dt * reduce_blocks(
                 body.points.size(), state.filter_powers, 0.0,
                 [&](Range block) { return added_power(body.points, std::min(Dim, filter.volume_axes), block); },
                 std::plus<double>());
  }
}

template void filter_stresses<2>(State<2>&, const Model<2>&, double);
template void filter_stresses<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
