/// A field drawn on the deformed specimen: PNG files that need no display.
#pragma once

#include "core/draw/scale.hpp"
#include "core/io/frame.hpp"

#include <filesystem>
#include <optional>

namespace riedel {

struct PictureOptions {
  std::string field;
  int component = 0;
  double unit = 1.0; ///< factor for the frame's numbers
  std::string title, subtitle;
  std::string label;                  ///< of the colour bar, with the unit: "void ratio e [-]"
  std::optional<Interval> range = {}; ///< of the colours, in that unit; from the data if not given
  int width = 1600, height = 1200;    ///< maximum [px]; one of the two shrinks to fit the specimen
};

/// One of several specimens side by side.
struct Panel {
  const Frame* frame = nullptr; ///< 2-D, with domains
  std::string title, subtitle;
};

/// Every point's domain in the colour of the point's value, with axes in millimetres and a colour bar (viridis). Values
/// that are not finite are grey. Throws InputError for a 3-D frame or an unknown field, RunError with path and reason
/// if the file cannot be written.
void write_field_picture(const std::filesystem::path& path, const Frame& frame, const PictureOptions& options);

/// The same for several frames with a common length scale and colour scale; titles are those of the panels, and the
/// options' title is above all of them.
void write_field_pictures(const std::filesystem::path& path, const std::vector<Panel>& panels,
                          const PictureOptions& options);

} // namespace riedel
