#include "apps/biaxial/geometry.hpp"

#include "core/base/tensor.hpp"

#include <cmath>
#include <numbers>

namespace riedel {

double specimen_depth(const BiaxialCase& values) {
  if (values.grid.dimensions == 2) return 1.0;
  const double cell = values.specimen.width / static_cast<double>(values.grid.cells[0]);
  return cell * static_cast<double>(values.specimen.depth_cells);
}

Turn::Turn(const BiaxialCase& v)
    : centre(0.5 * v.specimen.width, 0.5 * v.specimen.height), is_none(v.specimen.rotation == 0.0) {
  const double angle = v.specimen.rotation * std::numbers::pi / 180.0;
  rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  if (is_none) rotation.setIdentity();
}

template <int Dim>
void turn_points(Points<Dim>& points, const Turn& turn) {
  if constexpr (Dim == 2) {
    const Mat<2>& R = turn.rotation;
    for (Index p = 0; p < points.size(); ++p) {
      const Vec<2> x = turn.to_grid(points.position_of(p));
      const Mat<2> F = R * points.deformation_gradient_of(p);
      Mat<2> stress;
      const double shear = points.stress[3][p] / std::numbers::sqrt2;
      stress << points.stress[0][p], shear, shear, points.stress[1][p];
      stress = (R * stress * R.transpose()).eval();
      for (int i = 0; i < 2; ++i) {
        points.position[i][p] = x[i];
        points.stress[i][p] = stress(i, i);
        for (int j = 0; j < 2; ++j) points.deformation_gradient[i * 2 + j][p] = F(i, j);
      }
      points.stress[3][p] = std::numbers::sqrt2 * stress(0, 1);
    }
  }
}

template <int Dim>
SpecimenGeometry<Dim>::SpecimenGeometry(const BiaxialCase& v, const ShapeFunction<Dim>& scheme) : turn(v) {
  size[0] = v.specimen.width;
  size[1] = v.specimen.height;
  for (int a = 0; a < 2; ++a) cells[a] = static_cast<Index>(v.grid.cells[static_cast<std::size_t>(a)]);
  if constexpr (Dim == 3) {
    size[2] = specimen_depth(v);
    cells[2] = static_cast<Index>(v.specimen.depth_cells);
  }
  for (int a = 0; a < Dim; ++a) cell[a] = size[a] / cells[a];
  // A block above a band slides sideways by about 0.7 u; the specimen may also bulge.
  const double sideways = 0.75 * v.loading.final_strain * size[1] + 0.15 * size[0];
  margin_below.fill(scheme.margin() + 1);
  margin_below[0] += static_cast<Index>(std::ceil(sideways / cell[0]));
  margin_above = margin_below;
  if (v.loading.platen == BiaxialCase::Platen::rigid_points) margin_above[1] += 3;
  if (!turn.is_none) margin_below[1] += 3;
}

template <int Dim>
Grid<Dim> SpecimenGeometry<Dim>::grid() const {
  Grid<Dim> grid;
  grid.cell = cell;
  for (int a = 0; a < Dim; ++a) {
    grid.origin[a] = -margin_below[a] * cell[a];
    grid.nodes[a] = cells[a] + margin_below[a] + margin_above[a] + 1;
  }
  if (turn.is_none) return grid;
  if constexpr (Dim == 2) { // the smallest grid that contains the specimen and its margins
    Vec<2> low = turn.centre, high = turn.centre;
    for (const double x : {-margin_below[0] * cell[0], size[0] + margin_above[0] * cell[0]})
      for (const double y : {-margin_below[1] * cell[1], size[1] + margin_above[1] * cell[1]}) {
        low = low.cwiseMin(turn.to_grid({x, y}));
        high = high.cwiseMax(turn.to_grid({x, y}));
      }
    for (int a = 0; a < 2; ++a) {
      grid.origin[a] = std::floor(low[a] / cell[a]) * cell[a];
      grid.nodes[a] = static_cast<Index>(std::ceil((high[a] - grid.origin[a]) / cell[a])) + 1;
    }
  }
  return grid;
}

PointRows::PointRows(const BiaxialCase& values) {
  const auto& cells = values.grid.cells;
  const auto per_cell = static_cast<std::size_t>(values.specimen.points_per_cell);
  in_row = static_cast<std::size_t>(cells[0]) * per_cell;
  in_layer = in_row * static_cast<std::size_t>(cells[1]) * per_cell;
}

template void turn_points<2>(Points<2>&, const Turn&);
template void turn_points<3>(Points<3>&, const Turn&);
template struct SpecimenGeometry<2>;
template struct SpecimenGeometry<3>;

} // namespace riedel
