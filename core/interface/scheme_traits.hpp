/// Properties of an interpolation scheme beyond the contract of its interface, from which benchmark problems and tests
/// take what to expect of it.
#pragma once

namespace riedel {

/// The domain over which the grid's functions are averaged for a point.
enum class PointDomain {
  none,      ///< evaluated at the point, or over a box independent of the points' sizes
  fixed,     ///< of the point's initial size
  stretched, ///< follows the point's deformation gradient
};

/// Every trait is tested for every registered scheme in both directions: what is claimed holds, and what is not claimed
/// does not. The defaults claim nothing.
struct SchemeTraits {
  /// Domains of a regular body fill it without gaps: under uniform stress, nodes are in equilibrium with the traction
  /// at an end that lies anywhere in a cell. `stretched` domains do so even if the body is strained.
  PointDomain domain = PointDomain::none;
  /// ∇N is continuous while a point moves across cell faces. Otherwise forces jump there, and a node with hardly any
  /// mass receives forces that do not vanish with its mass: USL is then unstable.
  bool continuous_gradients = false;
  /// Order in h [-] at which displacements converge while points cross cells, if enough points share a cell; 0: they
  /// need not converge.
  int order_across_cells = 0;
  /// They also converge, at least with order 1, in a body whose curved faces are free of traction.
  bool converges_at_free_faces = false;
  /// A pressure carried by the points along a side, spread by hats, is in equilibrium with a uniform stress for any
  /// number of points per cell.
  bool balances_pressure_on_points = false;
  /// Functions end at `Grid::walls`: the row of nodes on a wall alone determines the motion there.
  bool ends_at_walls = false;
  /// `ShapeFunction::move` places the points with its own weights: no transfer conserves angular momentum to round-off.
  bool moves_points = false;
  /// Largest error of a body in translation [-], in velocity, F and stress over their scales: round-off, and the part
  /// that gradients miss where a node below `ShapeFunction::mass_cutoff` is left out.
  double translation_error = 1e-12;
};

} // namespace riedel
