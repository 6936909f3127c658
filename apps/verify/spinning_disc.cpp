/// An elastic disc that rotates ten times about its centre, free of forces. It starts with a rigid rotation, so that it
/// widens by a hundredth and vibrates; angular momentum and the sum of kinetic and stored energy are conserved.
#include "apps/verify/spinning_disc.hpp"

#include "apps/verify/manufactured.hpp"
#include "apps/verify/measure.hpp"

namespace riedel {

namespace {

constexpr ElasticConstants solid{.modulus = 1e6, .poisson = 0.3, .density = 1000.0};
constexpr double radius = 0.4, turns = 10.0;          ///< radius [m]
const double rate = 0.1 * solid.bar_speed() / radius; ///< ω; its rim moves with a tenth of √(E/ρ) [1/s]
const Vec<2> middle(0.5, 0.5);                        ///< [m]

bool in_disc(const Vec<2>& X) { return (X - middle).norm() < radius; }

/// About the centre [kg m/s].
double angular_momentum_of(const Points<2>& points) {
  double sum = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2> arm = points.position_of(p) - middle, v = points.velocity_of(p);
    sum += points.mass[0][p] * (arm[0] * v[1] - arm[1] * v[0]);
  }
  return sum;
}

VerifyRun run_disc(const VerifyCase& given) {
  VerifySetup setup = make_setup<2>(given, {.cells = {given.cells, given.cells},
                                            .cell = 1.0 / given.cells,
                                            .material = "neo_hookean",
                                            .parameters = solid.parameters(),
                                            .holds = in_disc});
  const Index steps = setup.divide(turns * 2 * std::numbers::pi / rate, solid.wave_speed() + rate * radius, 0.2);
  setup.set_velocity([](const Vec<2>& X) { return Vec<2>(-rate * (X - middle)[1], rate * (X - middle)[0]); });
  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  const Points<2>& points = simulation.state().bodies.front().points;
  const double energy = simulation.energies().kinetic, momentum = angular_momentum_of(points);
  Watch watch(given);
  watch.run(simulation).until_step(steps).go();
  const Energies end = simulation.energies();
  const double change = angular_momentum_of(points) / momentum - 1.0;
  return {std::abs(change), watch.ns(), {change, (end.kinetic + end.internal) / energy - 1.0}};
}

Expectation expectation(const SchemeTraits&) { return {}; }

} // namespace

VerifyProblem spinning_disc_problem() {
  return {.name = "spinning_disc",
          .title = "free disc that rotates ten times",
          .measure = "Relative change of the angular momentum, which is conserved",
          .source = "closed form",
          .cells = {10, 20},
          .figures = {"spin", "energy"},
          .run = run_disc,
          .expected = expectation};
}

} // namespace riedel
