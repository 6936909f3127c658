/// The biaxial test of a homogeneous specimen, and the strain at which a shear band becomes possible.
#pragma once

#include "core/base/parameters.hpp"

#include <vector>

namespace riedel {

/// The first strain at which a band is possible, and the band's inclination to the horizontal.
struct Onset {
  double u_over_h = 0.0;        ///< [-]; 0: no band up to the end
  double inclination_deg = 0.0; ///< [deg]
};

/// The path over u/h0; compression positive.
struct HomogeneousTest {
  std::vector<double> u_over_h, angle, void_ratio; ///< [-], [deg], [-]
  double peak_angle = 0.0, peak_u_over_h = 0.0;    ///< [deg], [-]
  /// For the linear solid that responds to every rate as to one along the present D (Rudnicki & Rice 1975).
  Onset linear;
  /// For the law itself, whose responses inside and outside the band differ by ‖D‖ (Kolymbas 1981; Wu & Sikora 1991).
  Onset nonlinear;
};

/// Drained plane strain compression under constant lateral pressure from an isotropic state, with the law
/// gudehus_bauer. docs/theory/bifurcation.md gives the equations.
/// @param law the law's parameters   @param void_ratio e0   @param pressure [Pa]   @param end u/h0
HomogeneousTest homogeneous_test(const Values& law, double void_ratio, double pressure, double end);

/// The unloading path of such a specimen, followed by the blocks beside a band while the band softens.
struct Unloading {
  std::vector<double> u_over_h, angle; ///< [-], [deg], both decreasing
};
/// @param from u/h0 where unloading starts @return down to φ = 0
Unloading unloading_after(const Values& law, double void_ratio, double pressure, double from);

} // namespace riedel
