/// Weight of a neighbour by its distance.
#pragma once

#include "core/base/pack.hpp"

namespace riedel {

/// ω(r) = exp(−(r/l_c)²), cut off at r = 3 l_c, where it has fallen to 1.2e-4. Krzyżanowski et al. (2020), eq. (2),
/// without its prefactor, which cancels in the average.
class GaussWeight {
public:
  static constexpr double cut = 3.0; ///< distance at which the weight ends, in l_c [-]

  /// @param length l_c [m]
  explicit GaussWeight(double length) : per_square_(1.0 / square(length)) {}

  /// @param squared r² [m²]   @return s = (r/l_c)² [-]
  template <class Real>
  [[nodiscard]] Real scaled(const Real& squared) const {
    return squared * Real(per_square_);
  }
  /// @param s (r/l_c)² [-], a double, a pack or a batch of floats   @return ω [-]
  template <class Real>
  [[nodiscard]] static Real at(const Real& s) {
    return select(s <= Real(square(cut)), exp(-s), Real(0.0));
  }
  /// @param squared r² [m²]   @return ω [-]
  template <class Real>
  [[nodiscard]] Real operator()(const Real& squared) const {
    return at(scaled(squared));
  }

private:
  double per_square_; ///< 1/l_c² [1/m²]
};

} // namespace riedel
