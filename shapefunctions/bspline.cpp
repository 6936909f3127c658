#include "shapefunctions/bspline.hpp"

#include "shapefunctions/kit/tensor_product.hpp"
#include "shapefunctions/kit/wall_ends.hpp"

namespace riedel {

namespace {

using Factor = ValueGradient<Pack>;

/// If `there`, c_ghost = 2 c_near − c_far: the ghost node's factor is distributed to the two nodes before it.
void fold(Factor& ghost, Factor& near, Factor& far, const Mask& there) {
  const Pack N = select(there, ghost.value, Pack(0.0)), dN = select(there, ghost.gradient, Pack(0.0));
  ghost = {.value = ghost.value - N, .gradient = ghost.gradient - dN};
  near = {.value = near.value + (N + N), .gradient = near.gradient + (dN + dN)};
  far = {.value = far.value - N, .gradient = far.gradient - dN};
}

/// The first or the last of the nodes may be behind a wall, but never two on one side, since no point is behind a wall.
template <std::size_t Nodes>
std::array<Factor, Nodes> end_at_walls(std::array<Factor, Nodes> N, const Axis& axis) {
  fold(N[0], N[1], N[2], axis.first < Pack(axis.walls.first));
  fold(N[Nodes - 1], N[Nodes - 2], N[Nodes - 3], axis.first + Pack(Nodes - 1.0) > Pack(axis.walls.last));
  return N;
}

/// ½(3/2 − |r|)² at the outer nodes, 3/4 − r² at the nearest; r = s, s − 1, s − 2 in cells, 1/2 ≤ s < 3/2.
constexpr auto quadratic = [](const Pack& s, const Axis& axis) {
  const Pack a = Pack(1.5) - s, b = s - Pack(1.0), c = s - Pack(0.5);
  const std::array<Factor, 3> N{{{.value = Pack(0.5) * a * a, .gradient = -a * axis.per_h},
                                 {.value = Pack(0.75) - b * b, .gradient = Pack(-2.0) * b * axis.per_h},
                                 {.value = Pack(0.5) * c * c, .gradient = c * axis.per_h}}};
  return end_at_walls(N, axis);
};

/// (2 − |r|)³/6 at the outer nodes, 2/3 − r² + |r|³/2 at the inner ones; r = s, s − 1 … in cells, 1 ≤ s < 2.
constexpr auto cubic = [](const Pack& s, const Axis& axis) {
  const Pack t = s - Pack(1.0), u = Pack(2.0) - s, tt = t * t, uu = u * u;
  const Pack sixth(1.0 / 6.0), two_thirds(2.0 / 3.0), half(0.5), three_halves(1.5), two(2.0);
  const std::array<Factor, 4> N{
      {{.value = sixth * uu * u, .gradient = -half * uu * axis.per_h},
       {.value = two_thirds - tt * (Pack(1.0) - half * t), .gradient = -t * (two - three_halves * t) * axis.per_h},
       {.value = two_thirds - uu * (Pack(1.0) - half * u), .gradient = u * (two - three_halves * u) * axis.per_h},
       {.value = sixth * tt * t, .gradient = half * tt * axis.per_h}}};
  return end_at_walls(N, axis);
};

/// @param support half width of the functions' support, in cells
template <int Nodes, int Dim, class Function>
void fill(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils, double support,
          const Function& function) {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    std::array<AxisLanes, Dim> lanes;
    for (int a = 0; a < Dim; ++a)
      lanes[a] = {.position = before_walls(grid, a, load_lanes(points.position[a], p, points.size())),
                  .half_width = Pack((support - 1.0) * grid.cell[a])};
    fill_tensor_product<Dim, Nodes>(grid, lanes, stencils.group_of(p), function);
  }
}

} // namespace

template <int Dim>
void QuadraticBspline<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                                     Stencils<Dim>& stencils) const {
  fill<3>(grid, points, block, stencils, 1.5, quadratic);
}

template <int Dim>
void CubicBspline<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                                 Stencils<Dim>& stencils) const {
  fill<4>(grid, points, block, stencils, 2.0, cubic);
}

template class QuadraticBspline<2>;
template class QuadraticBspline<3>;
template class CubicBspline<2>;
template class CubicBspline<3>;

} // namespace riedel
