/// The paper's Figures 7 to 10 from the runs.
#pragma once

#include "apps/reproduce/paper_results.hpp"

namespace riedel {

/// Curves of Figures 7, 8, 9 and 10, those that were asked for, with what theory says beside them.
std::vector<FigurePart> curve_figures(const PaperResults& results);

/// Deformed specimens with their void ratios.
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
