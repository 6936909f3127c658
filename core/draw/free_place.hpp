/// Finds room for a text among the curves of a plot.
#pragma once

#include "core/draw/canvas.hpp"

#include <optional>
#include <vector>

namespace riedel {

/// What is already on the sheet.
struct Occupied {
  std::vector<std::vector<Spot>> lines;
  std::vector<Box> boxes;
};

/// A free box of that size within the area, with a gap to its sides and to everything on the sheet: corners first, then
/// along the sides, then anywhere.
std::optional<Box> free_place(const Box& area, double width, double height, double gap, const Occupied& occupied);

} // namespace riedel
