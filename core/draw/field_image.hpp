/// A field on the deformed specimen without annotations, for pages that add their own text.
#pragma once

#include "core/draw/raster_canvas.hpp"
#include "core/draw/scale.hpp"
#include "core/io/frame.hpp"

namespace riedel {

/// One number per point, and the colours for it.
struct FieldColors {
  std::string field;
  int component = 0;
  Interval range;    ///< covered by the colours of viridis
  double unit = 1.0; ///< factor for the frame's numbers

  /// Values in that unit. @throws InputError for an unknown field
  [[nodiscard]] std::vector<double> values(const Frame& frame) const;
};

/// Part of the plane that contains the domains of all frames, with a margin [m]; y upwards: top > bottom.
Box view_of(const std::vector<const Frame*>& frames);

/// The largest round length, 1, 2 or 5 times a power of ten, that does not exceed `maximum` [m].
double round_length(double maximum);

/// "20 mm" from a length [m], in the unit that makes the number short.
std::string length_text(double length);

/// Every point's domain in the colour of its value; values that are not finite are grey.
/// @param area of the canvas that shows the view [px]   @param scale [px/m]
void paint_field(RasterCanvas& canvas, const Frame& frame, const FieldColors& colors, const Box& view, const Box& area,
                 double scale);

/// The same as a PNG file's bytes, with a scale bar of a round length below. @param height without the bar [px]
std::string field_image(const Frame& frame, const FieldColors& colors, const Box& view, int height);

} // namespace riedel
