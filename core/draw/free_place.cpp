#include "core/draw/free_place.hpp"

#include "core/draw/clip.hpp"

namespace riedel {
namespace {

bool is_free(const Box& box, const Occupied& occupied) {
  for (const auto& line : occupied.lines)
    if (!clip(line, box).empty()) return false;
  for (const Box& other : occupied.boxes)
    if (box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom)
      return false;
  return true;
}

} // namespace

std::optional<Box> free_place(const Box& area, double width, double height, double gap, const Occupied& occupied) {
  const Box room{area.left + gap, area.top + gap, area.right - gap, area.bottom - gap};
  if (room.width() < width || room.height() < height) return std::nullopt;
  for (double down : {0.0, 1.0, 0.5, 0.25, 0.75})
    for (double across : {1.0, 0.0, 0.5, 0.75, 0.25, 0.875, 0.125}) {
      const double left = room.left + across * (room.width() - width), top = room.top + down * (room.height() - height);
      const Box place{left, top, left + width, top + height};
      if (is_free({left - gap, top - gap, place.right + gap, place.bottom + gap}, occupied)) return place;
    }
  return std::nullopt;
}

} // namespace riedel
