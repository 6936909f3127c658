#include "apps/section.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::vector<double> mean_of_layers(const std::vector<double>& values, std::size_t layers) {
  std::vector<double> mean(values.size() / layers, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) mean[i % mean.size()] += values[i];
  for (double& x : mean) x /= static_cast<double>(layers);
  return mean;
}

/// Mean of the lower and the upper face of each hexahedron.
std::vector<double> middle_faces(const std::vector<double>& hexahedra) {
  constexpr std::size_t face = 4 * 3;
  std::vector<double> quads;
  for (std::size_t i = 0; i < hexahedra.size(); i += 2 * face)
    for (std::size_t k = i; k < i + face; ++k) quads.push_back(0.5 * (hexahedra[k] + hexahedra[k + face]));
  return quads;
}

void put_in_plane(std::vector<double>& xyz) {
  for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] = 0.0;
}

} // namespace

Frame mean_over_depth(const Frame& slab, std::int64_t layers, double depth) {
  const auto count = static_cast<std::size_t>(layers);
  Frame plane{.dimension = 2,
              .time = slab.time,
              .u_over_h = slab.u_over_h,
              .position = mean_of_layers(slab.position, count),
              .corners = mean_of_layers(middle_faces(slab.corners), count),
              .fields = {}};
  put_in_plane(plane.position);
  put_in_plane(plane.corners);
  for (const Field& field : slab.fields) {
    if (field.name == "id") continue;
    plane.fields.push_back({field.name, field.components, field.unit, mean_of_layers(field.values, count)});
    if (field.name != "volume" && field.name != "mass") continue;
    plane.fields.back().unit = field.name == "volume" ? "m2" : "kg/m";
    for (double& x : plane.fields.back().values) x *= static_cast<double>(layers) / depth;
  }
  return plane;
}

} // namespace riedel
