/// Curves over one pair of axes, as SVG for papers and as PNG for a glance.
#pragma once

#include "core/draw/pens.hpp"
#include "core/draw/scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riedel {

enum class Style { solid, dashed, dotted, dots };

/// Values that are not finite interrupt the curve; one that stands alone between them is a dot.
struct Series {
  std::string label; ///< empty: not in the legend
  std::vector<double> x, y;
  Style style = Style::solid;
  std::optional<Color> color = {}; ///< by default the next of a palette that the colour-blind can tell apart
  std::string id = {};             ///< by which a page finds the curve in an SVG again
  std::vector<double> dashes = {}; ///< of a solid curve with a colour of its own
  Marker marker = Marker::none;    ///< at every point
};

/// The pen of a plot's n-th curve.
Pen pen_of(const Series& series, std::size_t number);

/// A horizontal line, for instance at a peak value of the literature.
struct ReferenceLine {
  double y = 0;
  std::string label; ///< stands on the line, where no curve passes
};

/// A grey area behind the curves, for instance a range of the literature. Sides beyond the axes are cut.
struct ShadedBox {
  Interval x, y;
  std::string label; ///< stands at its upper left corner
};

/// Texts that are too long for their place go on in the next line. A legend stands among the curves, else beside them,
/// else, in columns, beneath them, where the sheet becomes as much higher as it needs.
struct Plot {
  std::string title, x_label, y_label; ///< UTF-8; with the unit, as in "mobilised friction angle φ [°]"
  std::vector<Series> series;
  std::vector<ReferenceLine> references = {};
  std::vector<ShadedBox> shaded = {};
  bool log_x = false, log_y = false;                  ///< decimal logarithm; values that have none interrupt the curve
  std::optional<Interval> x_range = {}, y_range = {}; ///< from the data if not given; curves are cut at the axes
  double width = 640, height = 440;                   ///< without the legend beneath; a PNG has 2.5 pixels for each
  std::vector<double> x_ticks = {};                   ///< where they are not to be round numbers
};

/// All throw RunError with path and reason if the file cannot be written, and InputError if a curve has not as many x
/// as y.
void write_svg(const std::filesystem::path& path, const Plot& plot);
std::string svg_text(const Plot& plot);
void write_png(const std::filesystem::path& path, const Plot& plot);

} // namespace riedel
