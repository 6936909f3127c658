/// A field on the deformed specimen, and nothing else: for pages that add their own text.
#pragma once

#include "core/draw/raster_canvas.hpp"
#include "core/draw/scale.hpp"
#include "core/io/frame.hpp"

namespace riedel {

/// A number of every point, and the colours for it.
struct FieldColors {
  std::string field;
  int component = 0;
  Interval range;    ///< that the colours of viridis span
  double unit = 1.0; ///< what the frame's numbers are multiplied by

  /// In that unit. @throws InputError for an unknown field
  [[nodiscard]] std::vector<double> values(const Frame& frame) const;
};

/// Part of the plane that holds every frame's domains, and a margin [m]; y upwards: top > bottom.
Box view_of(const std::vector<const Frame*>& frames);

/// The greatest round length, 1, 2 or 5 times a power of ten, that is no longer than `most` [m].
double round_length(double maximum);

/// "20 mm" [m], in the unit that makes the number short.
std::string length_text(double length);

/// Every point's domain in the colour of its value; values that are not finite are grey.
/// @param area of the canvas that shows the view [px]   @param scale [px/m]
void paint_field(RasterCanvas& canvas, const Frame& frame, const FieldColors& colors, const Box& view, const Box& area,
                 double scale);

/// The same as a PNG file's bytes, with a bar beneath that shows a round length. @param height without the bar [px]
std::string field_image(const Frame& frame, const FieldColors& colors, const Box& view, int height);

} // namespace riedel
