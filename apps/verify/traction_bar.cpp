/// A bar along x, fixed at one end and pulled by a traction on the other, at rest in the end: σ_xx is the traction
/// everywhere. The pulled end lies at five positions in a cell, one after the other. With a strain of a millionth the
/// points stay in place.
#include "apps/verify/traction_bar.hpp"

#include "apps/riedel.hpp"
#include "apps/verify/measure.hpp"
#include "core/run/relax.hpp"

namespace riedel {

namespace {

constexpr double length = 1.0, modulus = 1e6, density = 1000.0, traction = 1.0; ///< of the box [m]

/// @param end of the bar, in cells
SurfaceTraction<2> pull(const Points<2>& points, double end, double growth) {
  SurfaceTraction<2> load{.value = [growth](const Vec<2>&, const Vec<2>& n, double time) -> Vec<2> {
                            return traction * std::min(1.0, time / growth) * n;
                          },
                          .initial_area = {}};
  load.initial_area.assign(static_cast<std::size_t>(points.size()), Vec<2>::Zero());
  for (Index p = 0; p < points.size(); ++p)
    if (points.position[0][p] > end - 1.5 * points.half_size[0][p])
      load.initial_area[static_cast<std::size_t>(p)][0] = 2.0 * points.half_size[1][p];
  return load;
}

/// Largest relative errors of the stress.
struct StressErrors {
  double at_end = 0.0; ///< less than a cell from the end
  double before = 0.0; ///< in the rest of the bar
};

/// @param share of the last cell that the bar fills
StressErrors errors_at_rest(const VerifyCase& given, double share, Watch& watch) {
  const double cell = length / given.cells, end = length - (1.0 - share) * cell;
  VerifySetup setup = make_setup<2>(
      given, {.cells = {given.cells, 2},
              .cell = cell,
              .filled = {end / length, 1.0},
              .material = "linear_elastic",
              .parameters = {{"youngs_modulus", modulus}, {"poissons_ratio", 0.0}, {"density", density}}});
  for (const Side side : {Side{0, false}, Side{1, false}}) setup.add_roller(side);
  setup.model.transfer = make(given.catalogue.in_2d.transfers, "flip", {{"flip", 0.0}});
  const double growth = 4.0 * length / std::sqrt(modulus / density); // the travel time of a wave over four lengths
  setup.model.surface_tractions.push_back(pull(setup.points(), end, growth));

  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  watch.run(simulation).until(growth).go();
  relax(simulation, 1000 * given.cells, watch.run(simulation));
  const Points<2>& points = simulation.state().bodies.front().points;
  StressErrors maximum;
  for (Index p = 0; p < points.size(); ++p) {
    double& error = points.position[0][p] > end - cell ? maximum.at_end : maximum.before;
    error = std::max(error, std::abs(points.stress[0][p] / traction - 1.0));
  }
  return maximum;
}

VerifyRun run_bar(const VerifyCase& given) {
  Watch watch(given);
  StressErrors maximum;
  for (const double share : {1.0, 0.13, 0.31, 0.5, 0.777}) {
    const StressErrors found = errors_at_rest(given, share, watch);
    maximum.at_end = std::max(maximum.at_end, found.at_end);
    maximum.before = std::max(maximum.before, found.before);
  }
  return {maximum.at_end, watch.ns(), {maximum.before}};
}

/// Where domains fill the bar, a uniform stress is in equilibrium with the traction. Hats at points and splines extend
/// beyond the end of the bar.
Expectation expectation(const SchemeTraits& scheme) {
  if (scheme.domain == PointDomain::none) return {};
  return {.text = "uniform", .max_error = 1e-4};
}

} // namespace

VerifyProblem traction_bar_problem() {
  return {.name = "traction_bar",
          .title = "bar under a traction on its end, at any position in a cell",
          .measure = "Largest relative error of the stress less than a cell from the end",
          .source = "closed form",
          .cells = {8},
          .figures = {"elsewhere"},
          .run = run_bar,
          .expected = expectation};
}

} // namespace riedel
