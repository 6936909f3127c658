#include "apps/verify/manufactured.hpp"

#include "apps/verify/measure.hpp"
#include "materials/neo_hookean.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

/// Moves the points to the start of the motion, with volume, b and stress of neo-Hookean material there.
template <int Dim>
void deform(VerifySetup<Dim>& setup, const Manufactured<Dim>& solution) {
  const auto& law = dynamic_cast<const NeoHookean&>(*setup.state.bodies.front().material);
  const int first = state_column(law.states(), "left_cauchy_green"),
            growth = state_column(law.states(), "volume_strain");
  Points<Dim>& points = setup.points();
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> X = points.position_of(p), u = solution.displacement(X, 0.0);
    const Mat<Dim> F = solution.gradient_at_start(X);
    Mat<3> in_space = Mat<3>::Identity();
    in_space.topLeftCorner<Dim, Dim>() = F;
    const Sym<double> b = to_sym(in_space * in_space.transpose()), sigma = law.stress(b);
    for (int a = 0; a < Dim; ++a) points.position[a][p] += u[a];
    for (int c = 0; c < Dim * Dim; ++c) points.deformation_gradient[c][p] = F(c / Dim, c % Dim);
    points.volume[0][p] = F.determinant() * points.initial_volume[0][p];
    for (int c = 0; c < 6; ++c) {
      points.stress[c][p] = sigma.m[static_cast<std::size_t>(c)];
      points.state[first + c][p] = b.m[static_cast<std::size_t>(c)];
    }
    points.state[growth][p] = std::log(F.determinant());
  }
}

} // namespace

template <int Dim>
VerifyRun run_manufactured(const VerifyCase& given, const Manufactured<Dim>& solution) {
  VerifySetup<Dim> setup = make_setup(given, solution.block);
  for (const Side& side : solution.rollers) setup.add_roller(side);
  const Index steps = setup.divide(solution.duration, solution.fastest, 0.2);
  setup.set_velocity(solution.velocity_at_start);
  setup.add_body_force(solution.body_force);
  const std::vector<Vec<Dim>> X = setup.places();
  if (solution.gradient_at_start) deform(setup, solution);

  Simulation<Dim> simulation(std::move(setup.model), std::move(setup.state));
  const Points<Dim>& points = simulation.state().bodies.front().points;
  Watch watch(given);
  ErrorNorm norm;
  const auto add_error = [&] {
    for (Index p = 0; p < points.size(); ++p) {
      const Vec<Dim>& start = start_of(points, p, X);
      const Vec<Dim> u = solution.displacement(start, simulation.state().time);
      norm.add(points.initial_volume[0][p], (points.position_of(p) - start - u).squaredNorm(), u.squaredNorm());
    }
  };
  watch.run(simulation).after_steps(1, add_error).until_step(steps).go();
  return {norm.value(), watch.ns()};
}

template VerifyRun run_manufactured<2>(const VerifyCase&, const Manufactured<2>&);
template VerifyRun run_manufactured<3>(const VerifyCase&, const Manufactured<3>&);

} // namespace riedel
