/// What an interpolation scheme promises beside the contract of its interface: problems with known answers and tests
/// take what to expect of it from here.
#pragma once

namespace riedel {

/// The domain over which the grid's functions are averaged for a point.
enum class PointDomain {
  none,      ///< they are evaluated at the point, or over a box that knows nothing of the points' sizes
  fixed,     ///< of the point's size at the start
  stretched, ///< follows the point's deformation gradient
};

/// Every trait is tested for every registered scheme in both directions: what is claimed holds, and what is not claimed
/// does not. The defaults claim nothing.
struct SchemeTraits {
  /// Domains of a regular body fill it without gaps: nodes of a uniform stress are in equilibrium with the traction at
  /// an end that lies anywhere in a cell. `stretched` ones still do so when the body is strained.
  PointDomain domain = PointDomain::none;
  /// ∇N is continuous while a point moves across the faces of cells. If not, forces jump there, and a node that hardly
  /// any mass reaches takes forces that do not fade with it: USL is unstable then.
  bool continuous_gradients = false;
  /// Order in h [-] at which displacements converge while points cross cells, where enough points share a cell; 0: they
  /// need not converge.
  int order_across_cells = 0;
  /// They also do, with order 1 at the least, in a body whose curved faces are free of traction.
  bool converges_at_free_faces = false;
  /// A pressure carried by the points along a side, which hats spread, is in equilibrium with a uniform stress however
  /// many points share a cell.
  bool balances_pressure_on_points = false;
  /// Functions end at `Grid::walls`: the row of nodes on a wall alone tells the motion there.
  bool ends_at_walls = false;
  /// `ShapeFunction::move` places the points, by weights of its own: no transfer keeps angular momentum to round-off.
  bool moves_points = false;
  /// Greatest error of a body in translation [-], of velocity, F and stress over their scales: round-off, and what
  /// gradients miss where a node under `ShapeFunction::mass_cutoff` is left out.
  double translation_error = 1e-12;
};

} // namespace riedel
