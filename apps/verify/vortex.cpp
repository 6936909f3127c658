/// Generalized vortex, a manufactured solution (Kamojjala, Brannon, Sadeghirad & Guilkey 2015, Engineering with
/// Computers 31): a ring 0.75 < R < 1.25 rotates about its centre by the angle α = g(t) h(R), h = 1 − 32 (R − 1)²
/// + 256 (R − 1)⁴, and its sides stay at rest and free of traction. In the basis (e_r, e_θ) at the point's position
/// b = I + γ (e_r ⊗ e_θ + e_θ ⊗ e_r) + γ² e_θ ⊗ e_θ with γ = R α′, J = 1 and σ = μ (b − I). Balance of momentum leaves
/// the body force −R α̇² + μ R α′²/ρ along e_r and R α̈ − μ (3 α′ + R α″)/ρ along e_θ.
#include "apps/verify/vortex.hpp"

namespace riedel {

namespace {

constexpr double pi = std::numbers::pi, duration = 1.0;
constexpr ElasticConstants solid{.modulus = 1000.0, .poisson = 0.3, .density = 1000.0};
constexpr double inner = 0.75, outer = 1.25, room = 1.25; ///< room: from the corner of the box to the middle
constexpr double angle = pi / 12;                         ///< maximum rotation
const Vec<2> middle(room, room);

Vec<2> turned(const Vec<2>& v, double by) {
  return {std::cos(by) * v[0] - std::sin(by) * v[1], std::sin(by) * v[0] + std::cos(by) * v[1]};
}

/// h and its derivatives.
std::array<double, 3> profile(double R) {
  const double s = R - 1.0;
  return {1 - 32 * s * s + 256 * s * s * s * s, -64 * s + 1024 * s * s * s, -64 + 3072 * s * s};
}

Vec<2> displacement(const Vec<2>& X, double t) {
  const Vec<2> arm = X - middle;
  return turned(arm, angle * std::sin(pi * t / duration) * profile(arm.norm())[0]) - arm;
}

Vec<2> velocity_at_start(const Vec<2>& X) {
  const Vec<2> arm = X - middle;
  const double rate = angle * pi / duration * profile(arm.norm())[0];
  return {-rate * arm[1], rate * arm[0]};
}

Vec<2> body_force(const Vec<2>& X, double t) {
  const Vec<2> arm = X - middle;
  const double R = arm.norm(), w = pi / duration, sine = std::sin(w * t);
  const auto [h, slope, bend] = profile(R);
  const double rate = angle * w * std::cos(w * t) * h, growth = -angle * w * w * sine * h; // α̇, α̈
  const double d1 = angle * sine * slope, d2 = angle * sine * bend;                        // α′, α″
  const Vec<2> e_r = turned(arm / R, angle * sine * h), e_theta(-e_r[1], e_r[0]);
  const double mu = solid.mu(), density = solid.density;
  return (-R * rate * rate + mu * R * d1 * d1 / density) * e_r +
         (R * growth - mu * (3 * d1 + R * d2) / density) * e_theta;
}

bool in_ring(const Vec<2>& X) {
  const double R = (X - middle).norm();
  return R > inner && R < outer;
}

VerifyRun run_vortex(const VerifyCase& given) { return run_manufactured(given, vortex(given.cells)); }

} // namespace

Manufactured<2> vortex(Index cells) {
  const double stretch = 1 + angle * 7.8; // at least that of the most sheared points: bounds their wave speed
  return {
      .block = {.cells = {5 * cells, 5 * cells},
                .cell = (outer - inner) / cells,
                .points = 3, // shear moves points 2.3 times as far apart; two points would separate by more than a cell
                .material = "neo_hookean",
                .parameters = solid.parameters(),
                .holds = in_ring},
      .rollers = {},
      .duration = duration,
      .fastest = stretch * solid.wave_speed(),
      .displacement = displacement,
      .velocity_at_start = velocity_at_start,
      .body_force = body_force};
}

VerifyProblem vortex_problem() {
  return {.name = "vortex",
          .title = "generalized vortex, at most 15°",
          .measure = "Relative L2 error of the displacement there and back",
          .source = "Kamojjala, Brannon, Sadeghirad & Guilkey (2015)",
          .cells = {4, 8, 16},
          .figures = {},
          .run = run_vortex,
          .expected = expected_across_cells};
}

} // namespace riedel
