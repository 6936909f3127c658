/// Measures a shear band in a plane strain specimen. Choices and their reasons: docs/theory/shear_band.md.
#pragma once

#include <span>

namespace riedel {

/// What is known of the points, one number each.
struct BandFields {
  std::span<const double> x;                  ///< horizontal position [m]
  std::span<const double> y;                  ///< vertical position [m]
  std::span<const double> volume;             ///< per metre of thickness [m²]
  std::span<const double> void_ratio;         ///< e [-]
  std::span<const double> initial_void_ratio; ///< e0 [-]
  std::span<const double> rotation;           ///< of the point since the start, anticlockwise positive [rad]
  std::span<const double> shear;              ///< accumulated shear strain [-], or the norm of its rate [1/s]
  std::span<const double> rate = {};          ///< ‖D‖ at this instant [1/s]; empty: not known
};

struct BandSettings {
  double length = 0.0;          ///< l_c, to express the thickness in; 0: local [m]
  double threshold = 0.70;      ///< void ratio from which the paper counts a point to the band [-]
  double least_ratio = 2.0;     ///< localisation ratio below which there is no band [-]
  double least_dilation = 0.01; ///< rise of e over the rest of the specimen below which there is no band [-]
};

enum class BandKind { none, single, x };
[[nodiscard]] const char* name_of(BandKind kind); ///< "none", "single", "x"

/// The stronger of the two conjugate bands. Numbers that have no meaning are zero.
struct ShearBand {
  bool found = false;
  BandKind kind = BandKind::none;
  double inclination_deg = 0.0;    ///< to the horizontal, 0 to 90 [deg]
  bool rises_to_the_right = false; ///< else to the left
  double thickness_m = 0.0;        ///< the paper's way: area with e above the threshold over length [m]
  double thickness_fwhm_m = 0.0;   ///< full width at half maximum of the dilation across the band [m]
  double thickness_rate_m = 0.0;   ///< full width at half maximum of ‖D‖ across the band; 0: not known [m]
  double thickness_over_lc = 0.0;  ///< thickness_m / l_c; 0 for a local law [-]
  double threshold = 0.0;          ///< void ratio that thickness_m counts from [-]
  double void_ratio_inside = 0.0;  ///< mean e over the middle half of the width [-]
  double localisation_ratio = 0.0; ///< mean of the top tenth of `shear` over its median [-]
  double conjugate_ratio = 0.0;    ///< dilated volume of the weaker band over that of the stronger [-]
  double straight_length_m = 0.0;  ///< length of the part that was measured [m]
};

[[nodiscard]] ShearBand measure_shear_band(const BandFields& fields, const BandSettings& settings = {});

} // namespace riedel
