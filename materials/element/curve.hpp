/// Results of an element test by any driver: one row per output, and how it ended.
#pragma once

#include "materials/element/material_point.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>

namespace riedel {

/// Compression is positive; stresses are total ones if there is pore water. 1 is the direction of loading. In the shear
/// test 1 is the direction of shear and 2 the normal to the sheared planes.
struct ElementRow {
  std::array<double, 3> eps{};       ///< change of length over initial length [-]
  double gamma = 0.0;                ///< u/h0 of planes normal to 2 along 1 [-]
  std::array<double, 3> sigma{};     ///< Cauchy [Pa]
  double tau = 0.0;                  ///< [Pa]
  double void_ratio = 0.0;           ///< [-]
  double phi_mob = 0.0;              ///< mobilised friction angle [deg]
  double phi_principal = 0.0;        ///< asin((σ_I − σ_III)/(σ_I + σ_III)) [deg]
  double time = 0.0;                 ///< [s]
  std::int64_t stage = 1, cycle = 1; ///< of the path; repetition of the stage
  double pore_pressure = 0.0;        ///< [Pa]

  [[nodiscard]] double p() const { return (sigma[0] + sigma[1] + sigma[2]) / 3.0; } ///< [Pa]
  [[nodiscard]] double q() const { return sigma[0] - 0.5 * (sigma[1] + sigma[2]); } ///< [Pa]
};

/// A larger number would fill the memory, and no plot could show it.
inline constexpr std::size_t max_element_rows = 1'000'000;

/// Indicators of whether a specimen stayed quasi-static and homogeneous.
struct ElementEnergies {
  double kinetic = 0.0, internal = 0.0, external = 0.0; ///< at the end [J, or J/m in plane strain]
  double kinetic_over_internal =
      std::numeric_limits<double>::quiet_NaN(); ///< maximum, from a strain of 0.5 % on; NaN before [-]
  double stress_spread = std::numeric_limits<double>::quiet_NaN(); ///< largest deviation of a point's stress from the
                                                                   ///< mean, over the mean; sampled at intervals [-]
  double time_step_over_limit = 0.0;                               ///< largest time step over the stable one [-]
};

struct ElementCurve {
  std::string test;
  std::vector<ElementRow> rows{};
  std::string failure{};           ///< why the test stopped early; empty otherwise
  std::vector<std::string> ends{}; ///< for stages ended by a limit: which limit, and where
  std::string interrupted{};       ///< where the test was interrupted; empty otherwise
  bool water = false;              ///< rows have a pore pressure
  std::int64_t steps = 0;
  MaterialReport report{};
  std::optional<ElementEnergies> energies{}; ///< for a specimen only
};

/// asin((σ_I − σ_III)/(σ_I + σ_III)) of a stress, tension positive; 0 if there is no compression [deg].
double principal_angle(const Sym<double>& stress);

/// Definition of phi_mob, from the effective stress: by the principal stresses; asin((σ_1 − σ_2)/(σ_1 + σ_2)), which
/// leaves out the out-of-plane stress of a biaxial test; or atan(τ/σ_2), on the sheared planes.
enum class Friction { principal, in_plane, on_planes };

ElementRow element_row(const MaterialPoint& point, double void_ratio, Friction friction, double pore_pressure = 0.0);

/// Header of element.csv: with phi_principal_deg if planes are sheared, and with the pore water pressure at the end.
std::vector<std::string> element_columns(bool sheared, bool water);
std::vector<double> element_numbers(const ElementRow& row, bool sheared, bool water);

} // namespace riedel
