/// A bar of length L, fixed at one end, that vibrates along its axis in its first mode, with an amplitude so small that
/// points stay in place: v = v0 sin(πX/2L) cos(ωt), ω = πc/2L, c² = E/ρ. Sulsky, Chen & Schreyer (1995), Comput. Phys.
/// Commun. 87; Bardenhagen & Kober (2004), section 4.
#include "apps/verify/bar.hpp"

#include "apps/verify/measure.hpp"

namespace riedel {

namespace {

constexpr double length = 1.0, modulus = 1e6, density = 1000.0, strain = 1e-6;
const double wave = std::sqrt(modulus / density), omega = std::numbers::pi * wave / (2 * length);

double mode(double X) { return std::sin(std::numbers::pi * X / (2 * length)); }

/// Contribution of the mode to the points' velocities.
double modal_velocity(const Points<2>& points, const std::vector<Vec<2>>& X) {
  double sum = 0.0, whole = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const double shape = mode(start_of(points, p, X)[0]);
    sum += points.mass[0][p] * shape * points.velocity[0][p];
    whole += points.mass[0][p] * square(shape);
  }
  return sum / whole;
}

/// The exact solution after one period is the initial velocity. The frequency follows from the zeros of the mode's
/// velocity, half a period apart; the amplitude is the mode's velocity after the period.
VerifyRun run_bar(const VerifyCase& given) {
  VerifySetup setup = make_setup<2>(
      given, {.cells = {given.cells, 1},
              .cell = length / given.cells,
              .material = "linear_elastic",
              .parameters = {{"youngs_modulus", modulus}, {"poissons_ratio", 0.0}, {"density", density}}});
  for (const Side side : {Side{0, false}, Side{1, false}, Side{1, true}}) setup.add_roller(side);
  const double period = 2 * std::numbers::pi / omega;
  const Index steps = setup.divide(period, wave, 0.1);
  const std::vector<Vec<2>> X = setup.places();
  const double v0 = strain * wave;
  setup.set_velocity([v0](const Vec<2>& x) { return Vec<2>(v0 * mode(x[0]), 0.0); });

  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  const Points<2>& points = simulation.state().bodies.front().points;
  const double energy = simulation.energies().kinetic;
  Watch watch(given);
  std::vector<double> zeros;
  double before = modal_velocity(points, X);
  const auto look_for_zero = [&] {
    const double now = modal_velocity(points, X), last = static_cast<double>(simulation.state().step - 1);
    if (before * now <= 0.0) zeros.push_back((last + before / (before - now)) * simulation.time_step());
    before = now;
  };
  watch.run(simulation).after_steps(1, look_for_zero).until_step(steps).go();
  ErrorNorm norm;
  for (Index p = 0; p < points.size(); ++p) {
    const double exact = v0 * mode(start_of(points, p, X)[0]);
    norm.add(points.initial_volume[0][p], (points.velocity_of(p) - Vec<2>(exact, 0.0)).squaredNorm(), square(exact));
  }
  const Energies end = simulation.energies();
  const double frequency =
      zeros.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : period / (2 * (zeros[1] - zeros[0]));
  return {norm.value(), watch.ns(), {frequency - 1.0, before / v0 - 1.0, (end.kinetic + end.internal) / energy - 1.0}};
}

Expectation expectation(const SchemeTraits&) { return {"1 to 2", 1.0}; }

} // namespace

VerifyProblem bar_problem() {
  return {.name = "bar",
          .title = "axially vibrating bar",
          .measure = "Relative L2 error of the velocity after one period, v0 sin(πX/2L)",
          .source = "Sulsky, Chen & Schreyer (1995)",
          .cells = {8, 16, 32},
          .figures = {"frequency", "amplitude", "energy"},
          .run = run_bar,
          .expected = expectation};
}

} // namespace riedel
