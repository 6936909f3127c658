#include "core/draw/clip.hpp"

#include <cmath>

namespace riedel {

std::vector<std::vector<Spot>> clip(const std::vector<Spot>& line, const Box& box) {
  const auto finite = [](Spot s) { return std::isfinite(s.x) && std::isfinite(s.y); };
  const auto same = [](Spot s, Spot t) { return s.x == t.x && s.y == t.y; };
  std::vector<std::vector<Spot>> pieces;
  bool joined = false; // the last piece ends where the next segment begins
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Spot a = line[i - 1], b = line[i];
    const auto inside = finite(a) && finite(b) ? clip(a, b, box) : std::nullopt;
    if (!inside) {
      joined = false;
      continue;
    }
    if (!joined || !same(inside->first, a)) pieces.push_back({inside->first});
    pieces.back().push_back(inside->second);
    joined = same(inside->second, b);
  }
  return pieces;
}

} // namespace riedel
