/// A random field of void ratios that depends on position only, not on the grid and its points.
#pragma once

#include "core/base/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace riedel {

/// Gaussian, of mean zero, with the covariance σ² exp(−r²/λ²) between two places r apart, in the limit of many modes:
/// e(x) = σ √(2/M) Σ_m cos(k_m·x + φ_m), the components of k_m normal with deviation √2/λ, φ_m uniform (the spectral
/// method of Shinozuka & Deodatis 1991, with wave numbers drawn at random). It does not vary over the depth.
class VoidRatioField {
public:
  /// @param deviation σ [-] @param length λ, of correlation [m] @param seed number that selects the field
  VoidRatioField(double deviation, double length, std::uint64_t seed);

  [[nodiscard]] bool is_uniform() const { return modes_.empty(); }
  /// Deviation of the void ratio from the mean at a position [-].
  [[nodiscard]] double operator()(const Vec<2>& x) const;
  /// The same at all (x_i, y_j), up to round-off, much faster. @return a row for each x, a column for each y
  [[nodiscard]] Eigen::MatrixXd on_lattice(std::span<const double> x, std::span<const double> y) const;
  /// Upper bound of the field's absolute value [-].
  [[nodiscard]] double bound() const { return amplitude_ * static_cast<double>(modes_.size()); }

private:
  struct Mode {
    Vec<2> k;     ///< [1/m]
    double phase; ///< [rad]
  };
  double amplitude_ = 0.0;
  std::vector<Mode> modes_;
};

} // namespace riedel
