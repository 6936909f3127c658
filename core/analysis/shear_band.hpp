/// Measures a shear band in a plane strain specimen. Choices and their reasons: docs/theory/shear_band.md.
#pragma once

#include "core/analysis/band_line.hpp"

#include <limits>
#include <span>
#include <string>

namespace riedel {

/// Fields of the points, one number per point.
struct BandFields {
  std::span<const double> x;                  ///< horizontal position [m]
  std::span<const double> y;                  ///< vertical position [m]
  std::span<const double> volume;             ///< per metre of thickness [m²]
  std::span<const double> void_ratio;         ///< e [-]; empty: the law has none, and shear replaces the dilation
  std::span<const double> initial_void_ratio; ///< e0 [-]
  std::span<const double> rotation;           ///< of the point since the start, anticlockwise positive [rad]
  std::span<const double> shear;              ///< accumulated shear strain [-], or the norm of its rate [1/s]
  std::span<const double> rate = {};          ///< ‖D‖ at this instant [1/s]; empty: not known

  [[nodiscard]] bool by_shear() const { return void_ratio.empty(); }
};

struct BandSettings {
  double length = 0.0;           ///< l_c, by which the thickness is divided; 0: local [m]
  double threshold = 0.70;       ///< void ratio above which the paper counts a point in the band [-]
  double min_ratio = 2.0;        ///< localisation ratio below which there is no band [-]
  double min_dilation = 0.01;    ///< rise of e relative to the rest of the specimen below which there is no band [-]
  double min_slenderness = 1.25; ///< length of the straight part over the width below which a zone is diffuse [-]
};

/// `diffuse`: strain has localised, but hardly or not at all in a band.
enum class BandKind { none, diffuse, single, x };
[[nodiscard]] const char* name_of(BandKind kind); ///< "none", "diffuse", "single", "x"

/// Stands for a value that does not exist (NaN).
inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// The stronger of the two conjugate bands, or the diffuse zone. Values that do not exist are `no_figure`.
struct ShearBand {
  bool found = false; ///< a single band or an x
  BandKind kind = BandKind::none;
  bool by_shear = false;               ///< the shear strain replaces the dilation
  double inclination_deg = no_figure;  ///< to the horizontal, 0 to 90 [deg]
  bool rises_to_the_right = false;     ///< otherwise it rises to the left
  double thickness_m = no_figure;      ///< as in the paper: area with e above the threshold over length [m]
  double thickness_fwhm_m = no_figure; ///< full width at half maximum of the dilation across the band [m]
  /// Full width at half maximum of ‖D‖ across the band, if the rates are known [m].
  double thickness_rate_m = no_figure;
  double thickness_over_lc = no_figure;  ///< thickness_m / l_c; none for a local law [-]
  double threshold = no_figure;          ///< void ratio above which thickness_m counts a point [-]
  double void_ratio_inside = no_figure;  ///< mean e over the middle half of the width [-]
  double localisation_ratio = no_figure; ///< mean of the top tenth of `shear` over its median [-]
  double conjugate_ratio = no_figure;    ///< dilated volume of the weaker band over that of the stronger [-]
  double straight_length_m = no_figure;  ///< length of the part that was measured [m]

  BandLine line{}; ///< its centre and ends, in the axes of the fields

  /// Why the values are doubtful: widths that differ by a factor of three, or a kind decided by chance. Empty: no
  /// doubt.
  [[nodiscard]] std::string doubt() const;
};

[[nodiscard]] ShearBand measure_shear_band(const BandFields& fields, const BandSettings& settings = {});

} // namespace riedel
