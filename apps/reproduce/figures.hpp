/// The paper's Figures 7 to 10 from the runs.
#pragma once

#include "apps/reproduce/paper_results.hpp"

namespace riedel {

/// Curves of Figures 7, 8, 9 and 10, those that were asked for, with what theory says beside them.
std::vector<FigurePart> curve_figures(const PaperResults& results);

/// The bands' thickness and inclination beside what is known of tests, all ways in one plot.
std::vector<FigurePart> experiment_figures(const std::vector<PaperResults>& ways);

/// Deformed specimens: void ratio, and what it hides, pressure and rate.
struct SpecimenFigure {
  int figure = 0;
  std::string name, caption;
  std::vector<RunResult> runs;
};
std::vector<SpecimenFigure> specimen_figures(const PaperResults& results);

/// figure_*.png in the folder. @return their names
std::vector<std::string> write_figures(const std::vector<FigurePart>& curves,
                                       const std::vector<SpecimenFigure>& specimens,
                                       const std::filesystem::path& folder);

} // namespace riedel
