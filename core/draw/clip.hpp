/// Clips lines at a box.
#pragma once

#include "core/draw/canvas.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace riedel {

/// The part of the segment from a to b within the box, if any. Liang and Barsky (1984), ACM Trans. Graph. 3(1).
inline std::optional<std::pair<Spot, Spot>> clip(Spot a, Spot b, const Box& box) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  double enter = 0, leave = 1;
  const auto cut = [&](double step, double room) { // keeps step t <= room
    if (step == 0) return room >= 0;
    (step > 0 ? leave = std::min(leave, room / step) : enter = std::max(enter, room / step));
    return enter <= leave;
  };
  if (!cut(-dx, a.x - box.left) || !cut(dx, box.right - a.x) || !cut(-dy, a.y - box.top) || !cut(dy, box.bottom - a.y))
    return std::nullopt;
  // Ends that are not cut stay identical to the bit, unlike a + 1 (b − a); round-off moves no cut end out of the box.
  const auto spot = [&](double t) {
    return Spot{std::clamp(a.x + t * dx, box.left, box.right), std::clamp(a.y + t * dy, box.top, box.bottom)};
  };
  return std::pair{enter > 0 ? spot(enter) : a, leave < 1 ? spot(leave) : b};
}

/// The pieces of a line within the box. Points that are not finite interrupt the line.
std::vector<std::vector<Spot>> clip(const std::vector<Spot>& line, const Box& box);

} // namespace riedel
