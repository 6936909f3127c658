#include "apps/verify/axis_aligned.hpp"

namespace riedel {

namespace {

constexpr double pi = std::numbers::pi;
constexpr ElasticConstants solid{.modulus = 1e7, .poisson = 0.3, .density = 1000.0};

/// With F diagonal P_aa = μ (F_aa − 1/F_aa) + λ ln J/F_aa, and b = ∂²u/∂t² − (1/ρ) ∂P/∂X gives the body force.
template <int Dim>
struct AxisAligned {
  double amplitude;                          ///< A [m]
  Vec<Dim> phase;                            ///< φ [-]
  double frequency = pi * solid.bar_speed(); ///< cπ [1/s]

  [[nodiscard]] double swing(int a, double t) const { return amplitude * std::sin(frequency * t + phase[a]); }

  [[nodiscard]] Vec<Dim> displacement(const Vec<Dim>& X, double t) const {
    Vec<Dim> u;
    for (int a = 0; a < Dim; ++a) u[a] = swing(a, t) * std::sin(2 * pi * X[a]);
    return u;
  }
  [[nodiscard]] Vec<Dim> velocity_at_start(const Vec<Dim>& X) const {
    Vec<Dim> v;
    for (int a = 0; a < Dim; ++a) v[a] = amplitude * frequency * std::cos(phase[a]) * std::sin(2 * pi * X[a]);
    return v;
  }
  /// F_aa
  [[nodiscard]] Vec<Dim> stretches(const Vec<Dim>& X, double t) const {
    Vec<Dim> F;
    for (int a = 0; a < Dim; ++a) F[a] = 1 + 2 * pi * swing(a, t) * std::cos(2 * pi * X[a]);
    return F;
  }
  [[nodiscard]] Vec<Dim> body_force(const Vec<Dim>& X, double t) const {
    const Vec<Dim> u = displacement(X, t), F = stretches(X, t);
    const double lambda = solid.lambda(), mu = solid.mu(), ln_J = F.array().log().sum();
    Vec<Dim> b;
    for (int a = 0; a < Dim; ++a) {
      const double slope = -4 * pi * pi * u[a]; // ∂F_aa/∂X_a
      b[a] = -square(frequency) * u[a] - (mu + (mu + lambda * (1 - ln_J)) / square(F[a])) * slope / solid.density;
    }
    return b;
  }
};

template <int Dim>
Manufactured<Dim> solution_of(const AxisAligned<Dim>& motion, Index cells) {
  Manufactured<Dim> solution{
      .block = {.cell = 1.0 / cells, .material = "neo_hookean", .parameters = solid.parameters()},
      .duration = 2 * pi / motion.frequency, // one period
      .fastest = solid.wave_speed(),
      .displacement = [=](const Vec<Dim>& X, double t) { return motion.displacement(X, t); },
      .velocity_at_start = [=](const Vec<Dim>& X) { return motion.velocity_at_start(X); },
      .gradient_at_start = [=](const Vec<Dim>& X) -> Mat<Dim> { return motion.stretches(X, 0.0).asDiagonal(); },
      .body_force = [=](const Vec<Dim>& X, double t) { return motion.body_force(X, t); }};
  solution.block.cells.fill(cells);
  for (int axis = 0; axis < Dim; ++axis)
    for (const bool far : {false, true}) solution.rollers.push_back({axis, far});
  return solution;
}

} // namespace

Manufactured<2> axis_aligned_in_square(Index cells, double amplitude) {
  return solution_of(AxisAligned<2>{.amplitude = amplitude, .phase = {0.0, pi}}, cells);
}

Manufactured<3> axis_aligned_in_cube(Index cells, double amplitude) {
  return solution_of(AxisAligned<3>{.amplitude = amplitude, .phase = {0.0, 2 * pi / 3, 4 * pi / 3}}, cells);
}

} // namespace riedel
