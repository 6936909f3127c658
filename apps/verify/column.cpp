/// A column between rollers under its own growing weight, at rest in the end: σ_yy = −ρ0 g (l0 − Y), with Y the initial
/// height, at any strain because the width is constant. The foot is strained by 10 %, so that the upper points cross
/// cells.
#include "apps/verify/column.hpp"

#include "apps/riedel.hpp"
#include "apps/verify/measure.hpp"
#include "core/run/relax.hpp"

namespace riedel {

namespace {

constexpr double height = 1.0, modulus = 1e5, density = 1000.0, gravity = 10.0;

VerifyRun run_column(const VerifyCase& given) {
  VerifySetup setup = make_setup<2>(
      given, {.cells = {2, given.cells},
              .cell = height / given.cells,
              .material = "linear_elastic",
              .parameters = {{"youngs_modulus", modulus}, {"poissons_ratio", 0.0}, {"density", density}}});
  for (const Side side : {Side{0, false}, Side{0, true}, Side{1, false}}) setup.add_roller(side);
  setup.model.transfer = make(given.catalogue.in_2d.transfers, "flip", {{"flip", 0.0}});
  const std::vector<Vec<2>> Y = setup.places();
  const double growth = 4.0 * height / std::sqrt(modulus / density); // the travel time of a wave over four heights
  setup.add_body_force(
      [growth](const Vec<2>&, double time) { return Vec<2>(0.0, -gravity * std::min(1.0, time / growth)); });

  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  Watch watch(given);
  watch.run(simulation).until(growth).go();
  relax(simulation, 150 * given.cells, watch.run(simulation));
  const Points<2>& points = simulation.state().bodies.front().points;
  ErrorNorm norm;
  for (Index p = 0; p < points.size(); ++p) {
    const double exact = -density * gravity * (height - start_of(points, p, Y)[1]);
    norm.add(points.initial_volume[0][p], square(points.stress[1][p] - exact), square(exact));
  }
  return {norm.value(), watch.ns()};
}

/// Schemes that evaluate weights only at the point do not take the points' new lengths into account. Hats then do not
/// converge; the smooth ones keep an error of a hundredth.
Expectation expectation(const SchemeTraits& scheme) {
  if (scheme.domain == PointDomain::none) return {};
  return {"1", 0.5};
}

} // namespace

VerifyProblem column_problem() {
  return {.name = "column",
          .title = "column under its own growing weight, strain 10 %",
          .measure = "Relative L2 error of the stress, σ_yy = −ρ0 g (l0 − Y)",
          .source = "closed form",
          .cells = {8, 16, 32},
          .figures = {},
          .run = run_column,
          .expected = expectation};
}

} // namespace riedel
