/// Where the biaxial specimen stands in its grid, and the points that fill it.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/interface/shape_function.hpp"

namespace riedel {

/// Depth of the slab [m]; 1 in two dimensions, where all results are per metre of depth.
double specimen_depth(const BiaxialCase& values);

/// How the specimen lies in the grid: rotated about its centre by specimen.rotation.
struct Turn {
  Vec<2> centre;        ///< [m]
  Mat<2> rotation;      ///< from the specimen's axes to the grid's
  bool is_none = false; ///< exactly no rotation

  explicit Turn(const BiaxialCase& values);
  [[nodiscard]] Vec<2> to_grid(const Vec<2>& x) const { return centre + rotation * (x - centre); }
  [[nodiscard]] Vec<2> to_specimen(const Vec<2>& x) const { return centre + rotation.transpose() * (x - centre); }
};

/// Rotates points, their domains and stresses with the specimen.
template <int Dim>
void turn_points(Points<Dim>& points, const Turn& turn);

/// Quantities that follow from the case. In its own axes the specimen's lower corner is the origin.
template <int Dim>
struct SpecimenGeometry {
  Vec<Dim> size;                          ///< b0, h0 and the depth [m]
  Counts<Dim> cells;                      ///< over the specimen
  Vec<Dim> cell;                          ///< h [m]
  Counts<Dim> margin_below, margin_above; ///< cells of the grid beside the specimen, along each axis

  Turn turn;

  SpecimenGeometry(const BiaxialCase& values, const ShapeFunction<Dim>& scheme);
  [[nodiscard]] Grid<Dim> grid() const;
};

/// How the specimen's points are numbered: row by row along its width, and layer by layer of the depth.
struct PointRows {
  std::size_t in_row, in_layer;

  explicit PointRows(const BiaxialCase& values);
};

} // namespace riedel
