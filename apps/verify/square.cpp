/// Axis-aligned displacement in a unit square, a manufactured solution (Wallstedt & Guilkey 2008, J. Comput. Phys.
/// 227): u_x = A sin(2πX) sin(cπt), u_y = A sin(2πY) sin(cπt + π), c² = E/ρ, between rollers, neo-Hookean. With F
/// diagonal, P_xx = μ (F_xx − 1/F_xx) + λ ln J/F_xx, and b = ∂²u/∂t² − (1/ρ) ∂P/∂X gives the body force.
#include "apps/verify/square.hpp"

#include "apps/verify/block.hpp"

namespace riedel {

namespace {

constexpr double pi = std::numbers::pi, modulus = 1e7, poisson = 0.3, density = 1000.0;
const double lambda = modulus * poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = modulus / (2 * (1 + poisson));
const double c = std::sqrt(modulus / density), fastest = std::sqrt((lambda + 2 * mu) / density);

struct Motion {
  double amplitude; ///< A [m]

  [[nodiscard]] Vec<2> swing(double t) const {
    return {amplitude * std::sin(c * pi * t), amplitude * std::sin(c * pi * t + pi)};
  }
  [[nodiscard]] Vec<2> displacement(const Vec<2>& X, double t) const {
    const Vec<2> s = swing(t);
    return {s[0] * std::sin(2 * pi * X[0]), s[1] * std::sin(2 * pi * X[1])};
  }
  [[nodiscard]] Vec<2> velocity_at_start(const Vec<2>& X) const {
    return {amplitude * c * pi * std::sin(2 * pi * X[0]), -amplitude * c * pi * std::sin(2 * pi * X[1])};
  }
  [[nodiscard]] Vec<2> body_force(const Vec<2>& X, double t) const {
    const Vec<2> u = displacement(X, t), s = swing(t);
    const Vec<2> F(1 + 2 * pi * s[0] * std::cos(2 * pi * X[0]), 1 + 2 * pi * s[1] * std::cos(2 * pi * X[1]));
    const double ln_J = std::log(F[0] * F[1]);
    Vec<2> b;
    for (int a : {0, 1}) {
      const double slope = -4 * pi * pi * u[a]; // ∂F_aa/∂X_a
      b[a] = -square(c * pi) * u[a] - (mu + (mu + lambda * (1 - ln_J)) / square(F[a])) * slope / density;
    }
    return b;
  }
};

VerifyRun run_square(const Catalogue& catalogue, const std::string& scheme, Index cells, double amplitude) {
  const Motion motion{amplitude};
  VerifySetup setup =
      make_setup(catalogue, scheme,
                 {.cells = {cells, cells},
                  .cell = 1.0 / cells,
                  .material = "neo_hookean",
                  .parameters = {{"youngs_modulus", modulus}, {"poissons_ratio", poisson}, {"density", density}}});
  for (const int axis : {0, 1})
    for (const bool far_side : {false, true}) setup.add_roller(axis, far_side);
  const Index steps = setup.divide(2 / c, fastest, 0.2); // one period
  const std::vector<Vec<2>> X = setup.places();
  for (Index p = 0; p < setup.points().size(); ++p)
    for (const int a : {0, 1}) setup.points().velocity[a][p] = motion.velocity_at_start(X[p])[a];
  setup.model.body_forces.push_back({.per_mass = [&](const Points<2>& points, Index p, double time) {
    return motion.body_force(start_of(points, p, X), time);
  }});

  Simulation<2> simulation(std::move(setup.model), std::move(setup.state));
  Watch watch;
  ErrorNorm norm;
  for (Index i = 0; i < steps; ++i) {
    watch.step(simulation);
    const double t = simulation.state().time;
    add_displacements(norm, simulation.state().bodies.front().points, X,
                      [&](const Vec<2>& start) { return motion.displacement(start, t); });
  }
  return {norm.value(), watch.ns()};
}

VerifyRun run_still(const Catalogue& catalogue, const std::string& scheme, Index cells) {
  return run_square(catalogue, scheme, cells, 1e-3);
}
VerifyRun run_crossing(const Catalogue& catalogue, const std::string& scheme, Index cells) {
  return run_square(catalogue, scheme, cells, 0.05);
}

ExpectedOrder order_of_still(std::string_view) { return {1.5, "2"}; }
ExpectedOrder order_of_crossing(std::string_view scheme) {
  if (scheme == "linear") return {0.0, "none"};
  if (scheme == "bspline2" || scheme == "bspline3") return {1.5, "2"};
  return {1.0, "1 to 2"};
}

VerifyProblem square_problem(const std::string& name, const std::string& how) {
  return {.name = name,
          .title = "axis-aligned displacement in a unit square, " + how,
          .known = "displacement over one period",
          .source = "Wallstedt & Guilkey (2008)",
          .cells = {8, 16, 32},
          .figures = {},
          .run = nullptr,
          .expected = nullptr};
}

} // namespace

VerifyProblem still_square_problem() {
  VerifyProblem problem = square_problem("square", "amplitude 0.001: points stay in their cells");
  problem.run = run_still;
  problem.expected = order_of_still;
  return problem;
}

VerifyProblem crossing_square_problem() {
  VerifyProblem problem = square_problem("square_crossing", "amplitude 0.05: points cross cells");
  problem.run = run_crossing;
  problem.expected = order_of_crossing;
  return problem;
}

} // namespace riedel
