/// An interpolation scheme: from a block of points to their weights on the grid.
#pragma once

#include "core/base/registry.hpp"
#include "core/state/grid.hpp"
#include "core/state/points.hpp"
#include "core/state/stencils.hpp"

namespace riedel {

/// Contract, tested for every registered scheme in two and three dimensions: Σ N = 1, Σ ∇N = 0, linear fields and their
/// gradients are exact. N and ∇N may have different support.
template <int Dim>
class ShapeFunction {
public:
  virtual ~ShapeFunction() = default;
  ShapeFunction() = default;
  ShapeFunction(const ShapeFunction&) = delete;
  ShapeFunction& operator=(const ShapeFunction&) = delete;

  /// Most entries that one point's stencil can have.
  [[nodiscard]] virtual int max_nodes() const = 0;
  /// Layers of nodes needed beyond those of a cell that holds a point.
  [[nodiscard]] virtual int margin() const = 0;
  /// Fills the stencils of the points in `block`, whole groups of eight: `block.begin` is a multiple of eight. Lanes
  /// past the last point repeat it. A point whose support leaves the grid is marked lost and gets zero weights.
  virtual void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                        Stencils<Dim>& stencils) const = 0;
  /// Half edges of the domain that the scheme gives a point, as columns [m]; a box or a parallelogram to draw. For a
  /// scheme that knows no domain a box of the point's volume, in the proportions it started with, stands for it.
  [[nodiscard]] virtual Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const;
};

template <int Dim>
Mat<Dim> ShapeFunction<Dim>::domain(const Grid<Dim>&, const Points<Dim>& points, Index p) const {
  Vec<Dim> half;
  for (int a = 0; a < Dim; ++a) half[a] = points.half_size[a][p];
  return (half * std::pow(points.volume[0][p] / points.initial_volume[0][p], 1.0 / Dim)).asDiagonal();
}

template <int Dim>
using ShapeFunctions = Registry<std::unique_ptr<ShapeFunction<Dim>>()>;

} // namespace riedel
