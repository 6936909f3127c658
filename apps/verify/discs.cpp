/// Two elastic discs in a unit square that fly at each other along its diagonal, collide and part: Sulsky, Chen &
/// Schreyer (1994), Comput. Methods Appl. Mech. Engng 118. Momentum and the sum of kinetic and stored energy are
/// conserved; a part of the motion becomes vibration.
#include "apps/verify/discs.hpp"

#include "apps/verify/manufactured.hpp"
#include "apps/verify/measure.hpp"

namespace riedel {

namespace {

constexpr ElasticConstants solid{.modulus = 1000.0, .poisson = 0.3, .density = 1000.0};
constexpr double radius = 0.2, place = 0.2; ///< of the near disc's middle along both axes [m]
constexpr double speed = 0.1;               ///< along each axis [m/s]
constexpr double duration = 3.0;            ///< they touch at 1.59 s and part a second later

bool in_disc(const Vec<2>& X) {
  return (X - Vec<2>::Constant(place)).norm() < radius || (X - Vec<2>::Constant(1 - place)).norm() < radius;
}

Vec<2> velocity_at_start(const Vec<2>& X) { return Vec<2>::Constant(X[0] < 0.5 ? speed : -speed); }

Vec<2> momentum_of(const Points<2>& points) {
  Vec<2> sum = Vec<2>::Zero();
  for (Index p = 0; p < points.size(); ++p) sum += points.mass[0][p] * points.velocity_of(p);
  return sum;
}

VerifyRun run_discs(const VerifyCase& given) {
  VerifySetup setup = make_setup<2>(given, {.cells = {given.cells, given.cells},
                                            .cell = 1.0 / given.cells,
                                            .material = "neo_hookean",
                                            .parameters = solid.parameters(),
                                            .holds = in_disc});
  const Index steps = setup.divide(duration, solid.wave_speed() + std::numbers::sqrt2 * speed, 0.2);
  setup.set_velocity(velocity_at_start);
  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  const Points<2>& points = simulation.state().bodies.front().points;
  const Vec<2> momentum = momentum_of(points);
  const double energy = simulation.energies().kinetic, mass = energy / square(speed);
  Watch watch(given);
  watch.run(simulation).until_step(steps).go();
  const Energies end = simulation.energies();
  return {std::abs((end.kinetic + end.internal) / energy - 1.0),
          watch.ns(),
          {(momentum_of(points) - momentum).norm() / (mass * std::numbers::sqrt2 * speed),
           (end.kinetic + end.internal) / energy - 1.0, end.kinetic / energy - 1.0}};
}

/// At most the error of the time step. Discontinuous gradients add that of crossing cells.
Expectation expectation(const SchemeTraits& scheme) {
  if (!scheme.continuous_gradients) return {};
  return {.text = "below 0.01", .max_error = 0.01};
}

} // namespace

VerifyProblem discs_problem() {
  return {.name = "discs",
          .title = "two discs that collide and separate",
          .measure = "Relative change of the total energy, which is conserved",
          .source = "Sulsky, Chen & Schreyer (1994)",
          .cells = {20, 40},
          .figures = {"momentum", "energy", "kinetic"},
          .run = run_discs,
          .expected = expectation};
}

} // namespace riedel
