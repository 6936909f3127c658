/// The pictures of element tests.
#pragma once

#include "core/campaign/run_kind.hpp"
#include "core/draw/plot.hpp"
#include "core/io/table.hpp"
#include "materials/element/curve.hpp"

#include <optional>

namespace riedel {

/// A curve with its name in the legend; empty: no legend.
struct NamedCurve {
  std::string label;
  ElementCurve curve;
};

/// Shown in every picture beside the curves, for example a measured curve.
struct Overlay {
  std::string label;
  Table table; ///< columns named as in element.csv
};

/// @param curves of one test   @param subject follows the test's name in the title
/// @return all whose values change; those for which the overlay has no columns omit it
std::vector<NamedPlot> element_plots(const std::vector<NamedCurve>& curves, const std::optional<Overlay>& overlay,
                                     const std::string& subject);

/// The same as PNG files. @return their names
std::vector<std::string> draw_element(const std::vector<NamedCurve>& curves, const std::optional<Overlay>& overlay,
                                      const std::string& subject, const std::filesystem::path& folder);

/// @throws InputError when the file has no pair of columns that a picture of the test shows
Overlay read_overlay(const std::filesystem::path& path, const std::string& test);

} // namespace riedel
