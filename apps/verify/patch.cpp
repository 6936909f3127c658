#include "apps/verify/patch.hpp"

#include "core/step/boundaries/prescribed_velocity.hpp"

#include <algorithm>

namespace riedel {

namespace {

constexpr double modulus = 20e6, density = 2000.0;
const double wave = std::sqrt(1.35 * modulus / density); // with Poisson's ratio 0.3 [m/s]
constexpr Index steps = 100;                             ///< of a linear motion

/// Prescribes the velocity A x plus a constant on all nodes; no point moves by more than a few cells.
/// @return the constant [m/s]
template <int Dim>
Vec<Dim> hold_nodes_in(VerifySetup<Dim>& setup, const Mat<Dim>& A) {
  const Grid<Dim>& grid = setup.state.grid;
  Vec<Dim> constant = Vec<Dim>::Zero();
  for (int a = 0; a < Dim; ++a) {
    Index b = 0;
    A.row(a).cwiseAbs().maxCoeff(&b);
    const double slope = A(a, b);
    // Some schemes take the rows between which a body stretches as walls: here the grid's ends.
    const Index still = b == a ? 0 : grid.nodes[b] / 2, last = grid.nodes[b] - 1;
    VelocityOnNodes<Dim> condition{.name = "all nodes",
                                   .axis = a,
                                   .velocity = [=, h = grid.cell[b]](double) { return slope * h * (last - still); },
                                   .linear = LinearMotion{static_cast<int>(b), still, last}};
    for (std::size_t c = 0; c < Dim; ++c) condition.last[c] = grid.nodes[c] - 1;
    setup.model.conditions.push_back(prescribe(std::move(condition)));
    constant[a] = -slope * (grid.origin[b] + still * grid.cell[b]);
  }
  return constant;
}

} // namespace

template <int Dim>
VerifySetup<Dim> make_patch(const VerifyCase& given) {
  VerifyBlock<Dim> block{.cell = 1.0 / given.cells,
                         .material = "linear_elastic",
                         .parameters = {{"youngs_modulus", modulus}, {"poissons_ratio", 0.3}, {"density", density}}};
  block.cells.fill(given.cells);
  return make_setup(given, block);
}

template <int Dim>
double error_of_translation(VerifySetup<Dim> setup, Watch& watch) {
  Vec<Dim> v = Vec<Dim>::Constant(-0.07 * wave);
  v[0] = 0.11 * wave;
  const double cell = setup.state.grid.cell[0];
  const Index count = setup.divide(1.7 * cell / v[0], wave, 0.2);
  setup.set_velocity([v](const Vec<Dim>&) { return v; });
  const std::vector<Vec<Dim>> X = setup.places();
  Simulation<Dim> simulation(std::move(setup.model), std::move(setup.state));
  const Points<Dim>& points = simulation.state().bodies.front().points;
  watch.run(simulation).until_step(count).go();
  double error = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> x = start_of(points, p, X) + simulation.state().time * v;
    for (const double each : {(points.velocity_of(p) - v).norm() / v.norm(), (points.position_of(p) - x).norm() / cell,
                              (points.deformation_gradient_of(p) - Mat<Dim>::Identity()).norm()})
      error = std::max(error, each);
    for (int c = 0; c < 6; ++c) error = std::max(error, std::abs(points.stress[c][p]) / modulus);
  }
  return error;
}

template <int Dim>
double error_of_linear_motion(VerifySetup<Dim> setup, const Mat<Dim>& A, Watch& watch) {
  const double cell = setup.state.grid.cell[0], dt = 0.2 * cell / wave;
  setup.model.fixed_time_step = dt;
  const Mat<Dim> growth = Mat<Dim>::Identity() + A / steps;
  const Vec<Dim> constant = hold_nodes_in<Dim>(setup, A / (steps * dt));
  const std::vector<Vec<Dim>> X = setup.places();
  Simulation<Dim> simulation(std::move(setup.model), std::move(setup.state));
  const Points<Dim>& points = simulation.state().bodies.front().points;
  Mat<Dim> F = Mat<Dim>::Identity();
  Vec<Dim> shift = Vec<Dim>::Zero(); // x = F X + shift
  const auto follow = [&] {
    F = growth * F;
    shift = growth * shift + dt * constant;
  };
  watch.run(simulation).after_steps(1, follow).until_step(steps).go();
  double error = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> x = F * start_of(points, p, X) + shift;
    error =
        std::max({error, (points.deformation_gradient_of(p) - F).norm(), (points.position_of(p) - x).norm() / cell});
    for (int c = 0; c < 6; ++c) error = std::max(error, std::abs(points.stress[c][p] - points.stress[c][0]) / modulus);
  }
  return error;
}

namespace {

/// Errors of the translation, a rotation, a shear and a stretching.
template <int Dim>
std::array<double, 4> errors_of_motions(const VerifyCase& given, Watch& watch) {
  Mat<Dim> rotation = Mat<Dim>::Zero(), shear = rotation, stretching = rotation;
  rotation(0, 1) = -0.3;
  rotation(1, 0) = 0.3;
  shear(0, Dim - 1) = 0.3;
  stretching(0, 0) = 0.1;
  stretching(Dim - 1, Dim - 1) = -0.05;
  const auto error_of = [&](const Mat<Dim>& A) {
    return error_of_linear_motion<Dim>(make_patch<Dim>(given), A, watch);
  };
  return {error_of_translation<Dim>(make_patch<Dim>(given), watch), error_of(rotation), error_of(shear),
          error_of(stretching)};
}

VerifyRun run_patch(const VerifyCase& given) {
  Watch watch(given);
  const std::array<double, 4> plane = errors_of_motions<2>(given, watch), space = errors_of_motions<3>(given, watch);
  std::vector<double> figures;
  for (std::size_t i = 0; i < plane.size(); ++i) figures.push_back(std::max(plane[i], space[i]));
  return {*std::ranges::max_element(figures), watch.ns(), figures};
}

Expectation expectation(const SchemeTraits& scheme) { return {.text = "exact", .max_error = scheme.translation_error}; }

} // namespace

VerifyProblem patch_problem() {
  return {.name = "patch",
          .title = "translation, rotation, shear and stretching across cells, in two and three dimensions",
          .measure = "Largest error of velocity, position, F and stress",
          .source = "closed form",
          .cells = {4},
          .figures = {"translation", "rotation", "shear", "stretching"},
          .run = run_patch,
          .expected = expectation};
}

template VerifySetup<2> make_patch<2>(const VerifyCase&);
template VerifySetup<3> make_patch<3>(const VerifyCase&);
template double error_of_translation<2>(VerifySetup<2>, Watch&);
template double error_of_translation<3>(VerifySetup<3>, Watch&);
template double error_of_linear_motion<2>(VerifySetup<2>, const Mat<2>&, Watch&);
template double error_of_linear_motion<3>(VerifySetup<3>, const Mat<3>&, Watch&);

} // namespace riedel
