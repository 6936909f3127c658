/// Theory of a specimen that is cut by a shear band.
#pragma once

namespace riedel {

/// φ of the principal stresses in the critical state of plane strain, of gudehus_bauer: 34.345° for φ_c = 30°.
double plane_strain_critical_angle(double critical_angle_deg);

/// Shear over normal stress on planes at `theta` to the horizontal, in a specimen that mobilises φ [-].
double traction_ratio(double angle_deg, double theta_deg);
/// The φ that a specimen mobilises when a band at `theta` bears this traction ratio [deg].
double outer_angle(double traction_ratio, double theta_deg);

/// φ of the specimen when the band is in critical simple shear: the minimum at that inclination [deg].
double residual_angle(double critical_angle_deg, double theta_deg);

/// Inclinations that experiments are compared with, to the horizontal [deg].
struct BandAngles {
  double roscoe = 0.0;  ///< 45° + ψ/2, Roscoe (1970): no stretch along the band
  double arthur = 0.0;  ///< 45° + (φ + ψ)/4, Arthur et al. (1977), Vardoulakis (1980)
  double coulomb = 0.0; ///< 45° + φ/2, Coulomb: the plane that fails first
};
BandAngles band_angles(double friction_deg, double dilatancy_deg);

/// The quasi-static one-dimensional non-local band, from an independent program (tests/reference/README.md): e0 = 0.55,
/// 50 kPa, l_c = 1.5 mm, a band that starts at 55°.
struct BandState {
  double u_over_h = 0.0;        ///< [-]
  double angle = 0.0;           ///< φ of the specimen [deg]
  double inclination_deg = 0.0; ///< θ [deg]
  double thickness_e = 0.0;     ///< where e ≥ 0.70 [m]
  double thickness_rate = 0.0;  ///< full width at half maximum of ‖D‖ [m]
  double thickness_fwhm = 0.0;  ///< full width at half maximum of e − e0 [m]
};
/// By straight lines between rows.
BandState band_1d(double u_over_h);
/// φ of the specimen if the same band had another inclination: it bears the same traction ratio [deg].
double band_1d_angle(double u_over_h, double theta_deg);

} // namespace riedel
