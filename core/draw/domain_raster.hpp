/// Determines the point whose domain each pixel of a picture shows.
#pragma once

#include "core/draw/canvas.hpp"
#include "core/io/frame.hpp"

namespace riedel {

/// A grid of square cells over part of the plane, row by row from the top.
struct DomainRaster {
  int width = 0, height = 0;
  std::vector<int> owner; ///< number of the point whose domain is shown; -1 outside the specimen

  [[nodiscard]] int at(int column, int row) const {
    return owner[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

/// @param view part of the plane shown [m], y upwards: top > bottom   @param cell edge of a cell [m]
DomainRaster rasterise_domains(const Frame& frame, const Box& view, double cell);

} // namespace riedel
