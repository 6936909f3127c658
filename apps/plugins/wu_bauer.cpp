/// The simple hypoplastic law of Wu & Bauer (1994), Int. J. Numer. Anal. Meth. Geomech. 18, 833–862:
/// σ° = C1 tr(σ) D + C2 tr(σD)/tr(σ) σ + (C3 σ² + C4 σ*²)/tr(σ) ‖D‖.
/// docs/theory/wu_bauer.md derives the constants from stiffness, Poisson's ratio, friction and dilatancy.
#include "core/interface/plugin.hpp"
#include "materials/kit/rate_law.hpp"

#include <Eigen/LU>
#include <numbers>

namespace {

using namespace riedel;

/// a·a, the product of a symmetric tensor with itself.
template <class Real>
Sym<Real> squared(const Sym<Real>& a) {
  const Real half(0.5), r(std::numbers::sqrt2 / 2);
  const auto& [xx, yy, zz, xy, xz, yz] = a.m; // shear components are √2 times the tensor's
  return {{xx * xx + half * (xy * xy + xz * xz), yy * yy + half * (xy * xy + yz * yz),
           zz * zz + half * (xz * xz + yz * yz), (xx + yy) * xy + r * xz * yz, (xx + zz) * xz + r * xy * yz,
           (yy + zz) * yz + r * xy * xz}};
}

class WuBauer final : public RateLaw<WuBauer, 1> {
public:
  static constexpr std::string_view name = "wu_bauer", source = "Wu & Bauer (1994)";
  static constexpr std::string_view summary = "hypoplasticity of four constants, without limits of the void ratio";
  static constexpr bool frictional = true;

  static Keys parameters() {
    Keys keys{{"stiffness", 320.0, "-", more_than(0), "E/p: initial Young's modulus over the mean pressure"},
              {"poissons_ratio", 0.0, "-", within(-1, 0.5), "initial Poisson's ratio"},
              {"phi", 40.8, "deg", within(0, 90), "friction angle of steady flow in triaxial compression"},
              {"psi", 13.2, "deg", within(-90, 90), "its dilatancy angle"},
              {"grain_density", 2650.0, "kg/m3", more_than(0), "density of the grains"}};
    for (const Key& key : IntegrationControl::frictional_keys()) keys.push_back(key);
    return keys;
  }
  explicit WuBauer(const Values& given)
      : RateLaw(IntegrationControl(given)), grain_density_(given.number("grain_density")) {
    check_bounds(parameters(), given, name);
    calibrate(given);
  }

  template <class Real>
  Rate<Real, 1> rate(const Sym<Real>& sigma, const std::array<Real, 1>& e, const Sym<Real>& D, Real d) const {
    const Real P = trace(sigma);
    const Sym<Real> N = (Real(C_[2]) / P) * squared(sigma) + (Real(C_[3]) / P) * squared(deviator(sigma));
    return {.stress = (Real(C_[0]) * P) * D + (Real(C_[1]) * dot(sigma, D) / P) * sigma + d * N,
            .state = {(Real(1.0) + e[0]) * trace(D)}};
  }

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return {"rate_norm"}; }
  [[nodiscard]] double density(std::span<const double> state) const override {
    return grain_density_ / (1.0 + state[0]);
  }
  /// No eigenvalue of a compressive σ exceeds |tr σ|, so ‖σ°‖ is at most Σ|C| |tr σ| ‖D‖.
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override {
    double square_of_speed = 0.0;
    for (Index p = 0; p < batch.size; ++p) {
      const Sym<double> sigma = seen(Sym<double>{{batch.stress[0][p], batch.stress[1][p], batch.stress[2][p]}});
      const double stiffness = std::abs(trace(sigma)) * C_.lpNorm<1>();
      square_of_speed = std::max(square_of_speed, stiffness * (1.0 + batch.state[0][p]) / grain_density_);
    }
    return {.wave_speed = std::sqrt(square_of_speed)};
  }

private:
  /// σ° is linear in the constants: two of its components at the start of a triaxial compression under p = 1, and two
  /// in steady flow, make four equations.
  void calibrate(const Values& given) {
    const auto sine = [&](const char* key) { return std::sin(given.number(key) * std::numbers::pi / 180); };
    const double nu = given.number("poissons_ratio"), K = (1 + sine("phi")) / (1 - sine("phi"));
    const double widening = (1 + sine("psi")) / (1 - sine("psi")) / 2;
    Eigen::Matrix4d A;
    const auto add_rows = [&](int row, double sigma_1, const Vec<3>& D) {
      const Vec<3> sigma(sigma_1, -1.0, -1.0), dev = sigma.array() - sigma.sum() / 3;
      for (const int i : {0, 1})
        A.row(row + i) << sigma.sum() * D[i], sigma.dot(D) / sigma.sum() * sigma[i],
            square(sigma[i]) / sigma.sum() * D.norm(), square(dev[i]) / sigma.sum() * D.norm();
    };
    add_rows(0, -1.0, {-1.0, nu, nu});
    add_rows(2, -K, {-1.0, widening, widening});
    C_ = A.fullPivLu().solve(Eigen::Vector4d(-given.number("stiffness"), 0.0, 0.0, 0.0));
    for (double ratio = 1.0; ratio < 0.999 * K; ratio *= 1.01)
      if (!(flow_norm(ratio) < 1.0))
        throw InputError(
            "wu_bauer: stiffness, poissons_ratio, phi and psi do not fit together: steady flow occurs before "
            "phi is reached, at a stress ratio of " +
            short_text(ratio) + " instead of " + short_text(K) + "; use a smaller poissons_ratio");
  }
  /// ‖L⁻¹N‖ in a triaxial cell: 1 in steady flow, where L:D + N ‖D‖ = 0.
  [[nodiscard]] double flow_norm(double ratio) const {
    const Vec<3> sigma(-ratio, -1.0, -1.0), dev = sigma.array() - sigma.sum() / 3;
    const Mat<3> L = C_[0] * sigma.sum() * Mat<3>::Identity() + C_[1] / sigma.sum() * sigma * sigma.transpose();
    const Vec<3> N = (C_[2] * sigma.cwiseAbs2() + C_[3] * dev.cwiseAbs2()) / sigma.sum();
    return L.fullPivLu().solve(N).norm();
  }

  Eigen::Vector4d C_;    ///< C1 … C4 [-]
  double grain_density_; ///< [kg/m³]
  std::vector<StateVariable> states_{{"void_ratio", "-", "volume of the voids over volume of the grains"},
                                     separation_variable()};
};

} // namespace

RIEDEL_PLUGIN(riedel::material<WuBauer>)
