/// Expanding ring, a manufactured solution (Wallstedt & Guilkey 2008, J. Comput. Phys. 227): u = A sin(cπt) g(R) along
/// e_R, g = c3 R³ + c2 R² + c1 R, c² = E/ρ, in a ring 0.4 < R < 0.6 of neo-Hookean material with ν = 0, of which a
/// quarter between rollers is modelled. The coefficients make g(0.6) = 1 and g′ = 0 on both faces, which then are free
/// of traction at any A. With F = diag(1 + A sin(cπt) g′, 1 + A sin(cπt) g/R) and P = μ (F − F⁻¹), balance of momentum
/// leaves the body force ∂²u/∂t² − (∂P_R/∂R + (P_R − P_θ)/R)/ρ along e_R.
#include "apps/verify/ring.hpp"

namespace riedel {

namespace {

constexpr ElasticConstants solid{.modulus = 1e7, .poisson = 0.0, .density = 1000.0};
constexpr double inner = 0.4, outer = 0.6;                          // [m]
constexpr double amplitude = 0.1;                                   ///< A [m]
const double frequency = std::numbers::pi * solid.bar_speed();      ///< cπ [1/s]
constexpr double scale = 1 / (square(outer) * (outer - 3 * inner)); // [1/m³]
constexpr double c1 = -6 * inner * outer * scale, c2 = 3 * (outer + inner) * scale, c3 = -2 * scale;

/// g and its derivatives.
std::array<double, 3> profile(double R) {
  return {R * (c1 + R * (c2 + R * c3)), c1 + R * (2 * c2 + R * 3 * c3), 2 * c2 + R * 6 * c3};
}

double swing(double t) { return amplitude * std::sin(frequency * t); }

Vec<2> displacement(const Vec<2>& X, double t) {
  const double R = X.norm();
  return swing(t) * profile(R)[0] * X / R;
}

Vec<2> velocity_at_start(const Vec<2>& X) {
  const double R = X.norm();
  return amplitude * frequency * profile(R)[0] * X / R;
}

Vec<2> body_force(const Vec<2>& X, double t) {
  const double R = X.norm(), s = swing(t);
  const auto [g, slope, bend] = profile(R);
  const double F_R = 1 + s * slope, F_theta = 1 + s * g / R;
  const double difference = F_R - 1 / F_R - F_theta + 1 / F_theta; // (P_R − P_θ)/μ
  const double divergence = solid.mu() * ((1 + 1 / square(F_R)) * s * bend + difference / R);
  return (-square(frequency) * s * g - divergence / solid.density) * X / R;
}

bool in_ring(const Vec<2>& X) { return X.norm() > inner && X.norm() < outer; }

VerifyRun run_ring(const VerifyCase& given) { return run_manufactured(given, ring(given.cells)); }

} // namespace

Manufactured<2> ring(Index cells) {
  return {.block = {.cells = {4 * cells, 4 * cells}, // room for the ring at its widest
                    .cell = (outer - inner) / cells,
                    .material = "neo_hookean",
                    .parameters = solid.parameters(),
                    .holds = in_ring},
          .rollers = {{0, false}, {1, false}},
          .duration = 2 * std::numbers::pi / frequency, // one period
          .fastest = solid.wave_speed(),
          .displacement = displacement,
          .velocity_at_start = velocity_at_start,
          .body_force = body_force};
}

VerifyProblem ring_problem() {
  return {.name = "ring",
          .title = "quarter of a ring that expands and contracts, free at its curved faces",
          .measure = "Relative L2 error of the displacement over one period",
          .source = "Wallstedt & Guilkey (2008)",
          .cells = {4, 8, 16},
          .figures = {},
          .run = run_ring,
          .expected = expected_across_cells};
}

} // namespace riedel
