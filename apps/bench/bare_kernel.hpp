/// The reference of `riedel bench`: one hand-written step of the method, without choices at run time.
#pragma once

#include "core/state/grid.hpp"
#include "core/state/points.hpp"

namespace riedel {

/// Plane strain, USL, one body of uniform spacing on one grid, no boundaries, one thread. `Nodes` along an axis: 2 for
/// hats (the linear scheme), 3 for uniform GIMP. The law takes one Euler step without error control; otherwise the
/// step is that of `usl_step`, and a test compares the two.
///
/// Points are stored in packs of eight, all their numbers side by side, in the order of the first node that they touch;
/// a node is a cache line. While consecutive points touch the same nodes, sums stay in registers.
/// @tparam States number of the law's state variables that the rate depends on
template <class Law, std::size_t States, int Nodes>
class BareKernel {
public:
  BareKernel(const Law& law, const Grid<2>& grid, const Points<2>& points, double pressure, double flip);

  void step(double dt);
  /// Positions, velocities, F, volumes, stresses and states; `points` are those that the kernel was made from.
  void write(Points<2>& points) const;

private:
  template <int Components>
  using Lanes = double[Components][pack_size];
  struct alignas(64) Group {
    Lanes<2> x, v;
    Lanes<1> m, V, V_0;
    Lanes<4> F, sigma; ///< row by row; 11, 22, 33, √2·12
    Lanes<States + 1> state;
  };
  struct alignas(64) Weights {
    double N[2][Nodes][pack_size], dN[2][Nodes][pack_size];
    Index base[pack_size]; ///< first node
  };
  struct alignas(64) Node {
    double a[4], m; ///< (mv)_x, (mv)_y, f_x, f_y; then v_x, v_y, a_x, a_y
  };

  void find_weights(const Group& group, Weights& weights) const;
  void points_to_grid();
  void advance_nodes(double dt);
  void grid_to_points(const Group& group, Lanes<8>& rows) const;
  void update(Group& group, const Lanes<8>& columns, double dt) const;

  const Law& law_;
  Grid<2> grid_;
  double half_width_, pressure_, flip_, min_mass_;
  std::vector<Index> order_; ///< the given point at each place
  AlignedVector<Group> groups_;
  AlignedVector<Node> nodes_;
};

} // namespace riedel
