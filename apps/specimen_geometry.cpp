#include "apps/specimen_geometry.hpp"

#include <cmath>

namespace riedel {

int dimensions_of_biaxial(const Values& values) { return static_cast<int>(values.integer("grid.dimensions")); }

double specimen_depth(const Values& values) {
  if (dimensions_of_biaxial(values) == 2) return 1.0;
  const double cell = values.number("specimen.width") / static_cast<double>(values.integers("grid.cells")[0]);
  return cell * values.number("specimen.depth_cells");
}

template <int Dim>
SpecimenGeometry<Dim>::SpecimenGeometry(const Values& v, const ShapeFunction<Dim>& scheme) {
  size[0] = v.number("specimen.width");
  size[1] = v.number("specimen.height");
  for (int a = 0; a < 2; ++a) cells[a] = static_cast<Index>(v.integers("grid.cells")[static_cast<std::size_t>(a)]);
  if constexpr (Dim == 3) {
    size[2] = specimen_depth(v);
    cells[2] = static_cast<Index>(v.integer("specimen.depth_cells"));
  }
  for (int a = 0; a < Dim; ++a) cell[a] = size[a] / cells[a];
  // A block above a band slides sideways by about 0.7 u; the specimen may also bulge.
  const double sideways = 0.75 * v.number("loading.final_strain") * size[1] + 0.15 * size[0];
  margin_below.fill(scheme.margin() + 1);
  margin_below[0] += static_cast<Index>(std::ceil(sideways / cell[0]));
  margin_above = margin_below;
  if (v.text("loading.platen") == "rigid_points") margin_above[1] += 3;
}

template <int Dim>
Grid<Dim> SpecimenGeometry<Dim>::grid() const {
  Grid<Dim> grid;
  grid.cell = cell;
  for (int a = 0; a < Dim; ++a) {
    grid.origin[a] = -margin_below[a] * cell[a];
    grid.nodes[a] = cells[a] + margin_below[a] + margin_above[a] + 1;
  }
  return grid;
}

template <int Dim>
void fill_box(Points<Dim>& points, const Counts<Dim>& cells, const Vec<Dim>& cell, Index per_cell,
              const Vec<Dim>& corner, int states) {
  const Vec<Dim> spacing = cell / per_cell;
  Index all = 1;
  for (const Index n : cells) all *= n * per_cell;
  points.resize(all, states);
  for (Index p = 0; p < all; ++p) {
    for (int a = 0, rest = p; a < Dim; rest /= cells[a] * per_cell, ++a) {
      points.position[a][p] = corner[a] + (rest % (cells[a] * per_cell) + 0.5) * spacing[a];
      points.half_size[a][p] = 0.5 * spacing[a];
    }
    points.volume[0][p] = points.initial_volume[0][p] = spacing.prod();
  }
}

template struct SpecimenGeometry<2>;
template struct SpecimenGeometry<3>;
template void fill_box<2>(Points<2>&, const Counts<2>&, const Vec<2>&, Index, const Vec<2>&, int);
template void fill_box<3>(Points<3>&, const Counts<3>&, const Vec<3>&, Index, const Vec<3>&, int);

} // namespace riedel
