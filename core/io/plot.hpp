/// Curves over one pair of axes, as SVG for papers and as PNG for a glance.
#pragma once

#include "core/io/scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riedel {

enum class Style { solid, dashed, dotted, dots };

/// Values that are not finite interrupt the curve.
struct Series {
  std::string label; ///< empty: not in the legend
  std::vector<double> x, y;
  Style style = Style::solid;
  std::optional<Color> color = {}; ///< by default the next of a palette that the colour-blind can tell apart
  std::string id = {};             ///< by which a page finds the curve in an SVG again
};

/// The pen of the n-th curve that has neither colour nor style of its own: the palette again and again, with other
/// dashes each time.
Pen series_pen(std::size_t number);

/// A horizontal line, for instance at a peak value of the literature.
struct ReferenceLine {
  double y = 0;
  std::string label; ///< stands on the line, where no curve passes
};

struct Plot {
  std::string title, x_label, y_label; ///< UTF-8; with the unit, as in "mobilised friction angle φ [°]"
  std::vector<Series> series;
  std::vector<ReferenceLine> references = {};
  bool log_x = false; ///< decimal logarithm across; values that have none interrupt the curve
  std::optional<Interval> x_range = {}, y_range = {}; ///< from the data if not given; curves are cut at the axes
  double width = 640, height = 440;                   ///< a PNG has 2.5 pixels for each
};

/// All throw RunError with path and reason if the file cannot be written, and InputError if a curve has not as many x
/// as y.
void write_svg(const std::filesystem::path& path, const Plot& plot);
std::string svg_text(const Plot& plot);
void write_png(const std::filesystem::path& path, const Plot& plot);

} // namespace riedel
