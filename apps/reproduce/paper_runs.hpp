/// The biaxial tests behind the paper's Figures 7 to 10.
#pragma once

#include "core/case/vary.hpp"

#include <set>

namespace riedel {

/// Numbers of the figures that can be reproduced.
using Figures = std::set<int>;
inline const Figures all_figures{2, 3, 4, 5, 7, 8, 9, 10};

/// Names of runs: the paper's case belongs to all four figures.
inline constexpr const char* paper_run = "24x84";
/// The three meshes of Figure 7, with the automatic time step and with a fixed one.
std::vector<std::string> mesh_runs();
std::string with_fixed_step(const std::string& mesh_run);
inline constexpr double fixed_step = 1e-6; ///< [s]
/// Figure 8, by rising l_c.
std::vector<std::string> length_runs();
/// l_c of each of them [m]
const std::vector<double>& lengths();
/// Figure 10, by rising e0.
std::vector<std::string> density_runs();

/// How the runs are made.
struct Way {
  std::string name;                  ///< on the command line
  std::string title;                 ///< such as "as the paper did it"
  std::string scheme;                ///< unless another is requested
  std::string suffix;                ///< of the names and labels of its runs
  std::vector<std::string> settings; ///< "KEY=VALUE", followed by the user's
};
/// "paper": unfiltered stresses, damped per step. "filtered": without the stresses that the nodes do not resolve,
/// damped by time, and slow enough for the band after the peak.
const std::vector<Way>& all_ways();

/// The runs that these figures need, each a variant of the paper's case.
std::vector<Variant> paper_runs(const CaseFile& given, const Figures& figures, const Way& way);

} // namespace riedel
