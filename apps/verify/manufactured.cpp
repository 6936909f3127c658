#include "apps/verify/manufactured.hpp"

#include "apps/verify/measure.hpp"

namespace riedel {

template <int Dim>
VerifyRun run_manufactured(const VerifyCase& given, const Manufactured<Dim>& solution) {
  VerifySetup<Dim> setup = make_setup(given, solution.block);
  for (const Side& side : solution.rollers) setup.add_roller(side);
  const Index steps = setup.divide(solution.duration, solution.fastest, 0.2);
  setup.set_velocity(solution.velocity_at_start);
  setup.add_body_force(solution.body_force);
  const std::vector<Vec<Dim>> X = setup.places();

  Simulation<Dim> simulation(std::move(setup.model), std::move(setup.state));
  const Points<Dim>& points = simulation.state().bodies.front().points;
  Watch watch;
  ErrorNorm norm;
  for (Index i = 0; i < steps; ++i) {
    watch.step(simulation);
    for (Index p = 0; p < points.size(); ++p) {
      const Vec<Dim>& start = start_of(points, p, X);
      const Vec<Dim> u = solution.displacement(start, simulation.state().time);
      norm.add(points.initial_volume[0][p], (points.position_of(p) - start - u).squaredNorm(), u.squaredNorm());
    }
  }
  return {norm.value(), watch.ns()};
}

template VerifyRun run_manufactured<2>(const VerifyCase&, const Manufactured<2>&);
template VerifyRun run_manufactured<3>(const VerifyCase&, const Manufactured<3>&);

} // namespace riedel
