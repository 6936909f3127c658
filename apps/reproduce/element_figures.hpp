/// The paper's Figures 2 to 5: element tests at one point.
#pragma once

#include "apps/reproduce/paper_runs.hpp"
#include "core/campaign/run_result.hpp"

namespace riedel {

/// A part of a figure.
struct FigurePart {
  int figure = 0;
  std::string name; ///< such as "4a_500", also of its file
  std::string caption;
  Plot plot;
};

/// The element tests that these figures need.
std::vector<Variant> element_runs(const Figures& figures);

/// From runs that include those.
std::vector<FigurePart> element_figures(const Figures& figures, Runs runs);

/// e_c = e_c0 exp[−(3p/h_s)^n] of a law that has such parameters.   @param pressure p [Pa]
double critical_void_ratio(const Values& law, double pressure);

/// The end of triaxial compression at 500 kPa: φ and e at an axial strain of 70 %, for e0 = 0.60, 0.75, 0.90.
struct CriticalState {
  std::vector<double> angle, void_ratio; ///< [deg], [-]
  double expected_void_ratio = 0.0;      ///< e_c at the mean pressure there [-]
};
/// @param law the law's parameters
CriticalState triaxial_end(Runs runs, const Values& law);

} // namespace riedel
