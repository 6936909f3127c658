/// Curves over one pair of axes, as SVG for papers and as PNG for quick viewing.
#pragma once

#include "core/draw/pens.hpp"
#include "core/draw/scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riedel {

enum class Style { solid, dashed, dotted, dots };

/// Values that are not finite interrupt the curve; an isolated value between them is a dot.
struct Series {
  std::string label; ///< empty: not in the legend
  std::vector<double> x, y;
  Style style = Style::solid;
  std::optional<Color> color = {}; ///< by default the next of a colour-blind-safe palette
  std::string id = {};             ///< by which a page finds the curve in an SVG
  std::vector<double> dashes = {}; ///< of a solid curve with a colour of its own
  Marker marker = Marker::none;    ///< at every point
};

/// The pen of a plot's n-th curve.
Pen pen_of(const Series& series, std::size_t number);

/// A horizontal line, for instance at a peak value from the literature.
struct ReferenceLine {
  double y = 0;
  std::string label; ///< on the line, where no curve passes
};

/// A grey area behind the curves, for instance a range from the literature. It is clipped at the axes.
struct ShadedBox {
  Interval x, y;
  std::string label; ///< at its upper left corner
};

/// Texts that are too long are wrapped. A legend is placed among the curves, otherwise beside them, otherwise below
/// them in columns, for which the sheet is extended.
struct Plot {
  std::string title, x_label, y_label; ///< UTF-8; with the unit, as in "mobilised friction angle φ [°]"
  std::vector<Series> series;
  std::vector<ReferenceLine> references = {};
  std::vector<ShadedBox> shaded = {};
  bool log_x = false, log_y = false;                  ///< decimal logarithm; values that have none interrupt the curve
  std::optional<Interval> x_range = {}, y_range = {}; ///< from the data if not given; curves are cut at the axes
  double width = 640, height = 440;                   ///< without the legend below; a PNG has 2.5 pixels per unit
  std::vector<double> x_ticks = {};                   ///< if they are not to be round numbers
};

/// All throw RunError with path and reason if the file cannot be written, and InputError if a curve has different
/// numbers of x and y values.
void write_svg(const std::filesystem::path& path, const Plot& plot);
std::string svg_text(const Plot& plot);
void write_png(const std::filesystem::path& path, const Plot& plot);

} // namespace riedel
