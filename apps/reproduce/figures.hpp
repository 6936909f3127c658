/// The paper's Figures 7 to 10 from the runs.
#pragma once

#include "apps/reproduce/paper_results.hpp"

namespace riedel {

/// Curves of those of Figures 7, 8, 9 and 10 that were requested, compared with theory.
std::vector<FigurePart> curve_figures(const PaperResults& results);

/// Thickness and inclination of the bands compared with test results, all ways in one plot.
std::vector<FigurePart> experiment_figures(const std::vector<PaperResults>& ways);

/// Deformed specimens: void ratio, pressure and rate.
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
