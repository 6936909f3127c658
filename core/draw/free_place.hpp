/// Room for a text among the curves of a plot.
#pragma once

#include "core/draw/canvas.hpp"

#include <optional>
#include <vector>

namespace riedel {

/// What is on the sheet already.
struct Occupied {
  std::vector<std::vector<Spot>> lines;
  std::vector<Box> boxes;
};

/// A place of that size within the area, a gap away from its sides and from all that is there: corners first, then
/// along the sides, then anywhere.
std::optional<Box> free_place(const Box& area, double width, double height, double gap, const Occupied& occupied);

} // namespace riedel
