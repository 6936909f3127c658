/// The biaxial test of a specimen that stays homogeneous, and where along it a shear band becomes possible.
#pragma once

#include "core/base/parameters.hpp"

#include <vector>

namespace riedel {

/// The first strain at which a band is possible, and the band's inclination to the horizontal.
struct Onset {
  double u_over_h = 0.0;        ///< [-]; 0: none up to the end
  double inclination_deg = 0.0; ///< [deg]
};

/// The path, by u/h0; compression positive.
struct HomogeneousTest {
  std::vector<double> u_over_h, angle, void_ratio; ///< [-], [deg], [-]
  double peak_angle = 0.0, peak_u_over_h = 0.0;    ///< [deg], [-]
  /// Of the linear solid that takes every rate for one along the present D (Rudnicki & Rice 1975).
  Onset linear;
  /// Of the law itself, whose response inside the band and outside of it differ by ‖D‖ (Kolymbas 1981; Wu & Sikora
  /// 1991).
  Onset nonlinear;
};

/// Drained plane strain compression under constant lateral pressure from an isotropic state, with the law
/// gudehus_bauer. docs/theory/bifurcation.md has the equations.
/// @param law the law's parameters   @param void_ratio e0   @param pressure [Pa]   @param end u/h0
HomogeneousTest homogeneous_test(const Values& law, double void_ratio, double pressure, double end);

/// The way back of such a specimen, which the blocks beside a band take while this softens.
struct Unloading {
  std::vector<double> u_over_h, angle; ///< [-], [deg], both falling
};
/// @param from u/h0 where it turns back   @return down to φ = 0
Unloading unloading_after(const Values& law, double void_ratio, double pressure, double from);

} // namespace riedel
