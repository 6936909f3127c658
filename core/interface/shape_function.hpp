/// An interpolation scheme: from a block of points to their weights on the grid.
#pragma once

#include "core/base/registry.hpp"
#include "core/interface/scheme_traits.hpp"
#include "core/state/grid.hpp"
#include "core/state/nodes.hpp"
#include "core/state/points.hpp"
#include "core/state/stencils.hpp"

namespace riedel {

/// Corners of a point's domain [m]: corner c is on the upper side along axis a if bit a of c is set.
template <int Dim>
using Corners = std::array<Vec<Dim>, power(2, Dim)>;

/// Contract, tested for every registered scheme in two and three dimensions: Σ N = 1, Σ ∇N = 0; linear fields and their
/// gradients are exact. N and ∇N may have different support.
template <int Dim>
class ShapeFunction {
public:
  virtual ~ShapeFunction() = default;
  ShapeFunction() = default;
  ShapeFunction(const ShapeFunction&) = delete;
  ShapeFunction& operator=(const ShapeFunction&) = delete;

  /// Properties beyond the contract; benchmark problems and tests expect exactly these.
  [[nodiscard]] virtual SchemeTraits traits() const { return {}; }
  /// Maximum number of entries in one point's stencil.
  [[nodiscard]] virtual int max_nodes() const = 0;
  /// Layers of nodes needed beyond those of a cell that contains a point.
  [[nodiscard]] virtual int margin() const = 0;
  /// Share of a point's mass below which a node carries no motion [-]: tiny masses under hats have forces that do not
  /// vanish with the mass. If gradients vanish too, leaving out a node affects them sooner than the masses.
  [[nodiscard]] virtual double mass_cutoff() const { return 1e-12; }
  /// Fills the stencils of the points in `block`, in whole groups of eight: `block.begin` is a multiple of eight. Lanes
  /// past the last point repeat it. A point whose support leaves the grid is marked lost and gets zero weights.
  virtual void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                        Stencils<Dim>& stencils) const = 0;
  /// Whether a point has weight on both sides of it along every axis wherever it lies, so that Σ_i N_ip (x_i − x_p) ⊗
  /// (x_i − x_p) has an inverse, which affine transfers need. Hats at a point on a line of nodes have none.
  [[nodiscard]] virtual bool supports_affine() const { return true; }
  /// Whether its gradients are those of its weights. Otherwise the stresses in the nodal forces differ from those of
  /// the weights, and the stress filter, which uses the weights, is refused.
  [[nodiscard]] virtual bool gradients_follow_weights() const { return true; }

  /// Whether hats are interpolated between the corners of a point's domain, so that a load on one of its faces acts on
  /// the corners; otherwise exact hats are integrated over the domain.
  [[nodiscard]] virtual bool traction_at_corners() const { return false; }

  /// Numbers that the scheme stores for each point from step to step, in `points.scheme_data`: the library allocates
  /// them and keeps them with the points.
  [[nodiscard]] virtual int point_data_size() const { return 0; }
  /// Initialises these numbers from positions, domains and deformation.
  virtual void initialise(const Grid<Dim>&, Points<Dim>&) const {}
  /// At the end of a step, if there are such numbers: updates them, and positions if necessary, with the velocities of
  /// the nodes that deformed the points in `block`. Points may be moving on other threads.
  virtual void move(const Grid<Dim>&, const Nodes<Dim>&, double /*dt*/, Points<Dim>&, Range /*block*/) const {}

  /// Numbers that the scheme computes for each node at the start of a step.
  [[nodiscard]] virtual int node_data_size() const { return 0; }
  /// Computes them for one body, before its stencils: identical to the bit for any number of threads, without
  /// allocation. Stencils carry them to `evaluate`.
  virtual void prepare(const Grid<Dim>&, const Points<Dim>&, Columns& /*node_data*/) const {}

  /// Half edges of the point's domain, as columns [m]; a box or a parallelogram to draw. A scheme without domains gives
  /// a box of the point's volume, with its initial proportions.
  [[nodiscard]] virtual Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const;
  /// Corners of the domain to draw, if it is not a parallelogram.
  [[nodiscard]] virtual Corners<Dim> corners(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const;
};

template <int Dim>
Mat<Dim> ShapeFunction<Dim>::domain(const Grid<Dim>&, const Points<Dim>& points, Index p) const {
  Vec<Dim> half;
  for (int a = 0; a < Dim; ++a) half[a] = points.half_size[a][p];
  return (half * std::pow(points.volume[0][p] / points.initial_volume[0][p], 1.0 / Dim)).asDiagonal();
}

template <int Dim>
Corners<Dim> ShapeFunction<Dim>::corners(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const {
  const Mat<Dim> R = domain(grid, points, p);
  Corners<Dim> all;
  for (int c = 0; c < power(2, Dim); ++c) {
    all[c] = points.position_of(p);
    for (int a = 0; a < Dim; ++a) all[c] += ((c >> a) & 1 ? 1 : -1) * R.col(a);
  }
  return all;
}

/// Allocates and initialises what a scheme stores for each point.
template <int Dim>
void initialise(const ShapeFunction<Dim>& scheme, const Grid<Dim>& grid, Points<Dim>& points) {
  if (points.scheme_data.components() != scheme.point_data_size())
    points.scheme_data = Columns(scheme.point_data_size());
  if (points.scheme_data.size() != points.size()) points.scheme_data.resize(points.size());
  scheme.initialise(grid, points);
}

/// @param options the section `interpolation` of a case
template <int Dim>
using ShapeFunctions = Registry<std::unique_ptr<ShapeFunction<Dim>>(const Values& options)>;

} // namespace riedel
