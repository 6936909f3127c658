#include "shapefunctions/gimp.hpp"

#include "shapefunctions/kit/tensor_product.hpp"

#include <Eigen/Eigenvalues>

namespace riedel {

namespace {

/// The hat averaged over [r − l, r + l], l ≤ h: Bardenhagen & Kober (2004), eq. (44). The paper's cases by |r| are one
/// expression in the hat and its integral at the two ends, which also holds for boxes wider than a cell (l > h/2).
constexpr auto averaged_hat = [](const Pack& r, const Axis& axis) -> ValueGradient<Pack> {
  const Pack a = max(min(r - axis.l, axis.h), -axis.h), b = max(min(r + axis.l, axis.h), -axis.h); // inside the support
  const Pack a_share = abs(a) * axis.per_h, b_share = abs(b) * axis.per_h;
  // ∫ hat = s − s |s|/(2 h), the hat itself 1 − |s|/h.
  const Pack area = (b - a) + Pack(0.5) * (a * a_share - b * b_share);
  return {.value = area * axis.per_2l, .gradient = (a_share - b_share) * axis.per_2l};
};

/// The same for boxes no wider than a cell. They extend from u = s − l/h in the first cell to u + 2 l/h, in that cell
/// up to c, and t beyond it: the outer nodes average one arm of their hats, and the middle one gets the remainder to 1.
constexpr auto narrow_box = [](const Pack& s, const Axis& axis) -> std::array<ValueGradient<Pack>, 3> {
  const Pack half = axis.l * axis.per_h, u = s - half, c = min(s + half, Pack(1.0)), t = (s + half) - c;
  const Pack per_area = axis.per_2l * axis.h * Pack(0.5);
  const Pack first = (c - u) * (Pack(2.0) - (u + c)) * per_area, last = t * t * per_area;
  const Pack first_gradient = (u - c) * axis.per_2l, last_gradient = t * axis.per_2l;
  return {{{.value = first, .gradient = first_gradient},
           {.value = Pack(1.0) - (first + last), .gradient = -(first_gradient + last_gradient)},
           {.value = last, .gradient = last_gradient}}};
};
constexpr auto wide_box = [](const Pack& s, const Axis& axis) { return at_each_node<4>(s, axis, averaged_hat); };

/// Diagonal of U = √(FᵀF). In two dimensions U = (FᵀF + det F I)/tr U with tr U = √(tr FᵀF + 2 det F).
Vec<3> stretch_diagonal(const Mat<3>& F) {
  return Eigen::SelfAdjointEigenSolver<Mat<3>>(F.transpose() * F).operatorSqrt().diagonal();
}
template <class Real>
std::array<Real, 2> stretch_diagonal(const std::array<Real, 4>& F) {
  const Real c1 = F[0] * F[0] + F[2] * F[2], c2 = F[1] * F[1] + F[3] * F[3], J = F[0] * F[3] - F[1] * F[2];
  const Real per_trace = Real(1.0) / sqrt(c1 + c2 + J + J);
  return {(c1 + J) * per_trace, (c2 + J) * per_trace};
}

/// Half widths of the boxes of eight points from p on; lanes past the last point repeat it.
std::array<Pack, 2> cpgimp_half_widths(const Grid<2>& grid, const Points<2>& points, Index p) {
  std::array<Pack, 4> F;
  for (int c = 0; c < 4; ++c) F[c] = load_lanes(points.deformation_gradient[c], p, points.size());
  std::array<Pack, 2> l = stretch_diagonal(F);
  for (int a = 0; a < 2; ++a) l[a] = min(l[a] * load_lanes(points.half_size[a], p, points.size()), Pack(grid.cell[a]));
  return l;
}
std::array<Pack, 3> cpgimp_half_widths(const Grid<3>& grid, const Points<3>& points, Index p) {
  std::array<std::array<double, pack_size>, 3> width;
  for (Index k = 0; k < pack_size; ++k) {
    const Index q = std::min(p + k, points.size() - 1);
    const Vec<3> stretch = stretch_diagonal(points.deformation_gradient_of(q));
    for (int a = 0; a < 3; ++a) width[a][k] = std::min(points.half_size[a][q] * stretch[a], grid.cell[a]);
  }
  return {Pack::load(width[0].data()), Pack::load(width[1].data()), Pack::load(width[2].data())};
}

} // namespace

template <int Dim>
void Gimp<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    std::array<AxisLanes, Dim> lanes;
    for (int a = 0; a < Dim; ++a)
      lanes[a] = {.position = load_lanes(points.position[a], p, points.size()),
                  .half_width = Pack(grid.stretch[a]) * load_lanes(points.half_size[a], p, points.size())};
    fill_tensor_product<Dim, 3>(grid, lanes, stencils.group_of(p), narrow_box);
  }
}

template <int Dim>
Mat<Dim> Gimp<Dim>::domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const {
  Vec<Dim> half;
  for (int a = 0; a < Dim; ++a) half[a] = grid.stretch[a] * points.half_size[a][p];
  return half.asDiagonal();
}

template <int Dim>
void Cpgimp<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                           Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    const std::array<Pack, Dim> half_width = cpgimp_half_widths(grid, points, p);
    std::array<AxisLanes, Dim> lanes;
    bool small = true; // if no box is wider than a cell, three nodes along each axis are enough
    for (int a = 0; a < Dim; ++a) {
      lanes[a] = {.position = load_lanes(points.position[a], p, points.size()), .half_width = half_width[a]};
      small = small && all(lanes[a].half_width <= Pack(0.5 * grid.cell[a]));
    }
    if (small)
      fill_tensor_product<Dim, 3>(grid, lanes, stencils.group_of(p), narrow_box);
    else
      fill_tensor_product<Dim, 4>(grid, lanes, stencils.group_of(p), wide_box);
  }
}

template <int Dim>
Mat<Dim> Cpgimp<Dim>::domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const {
  const Index first = p / pack_size * pack_size;
  const std::array<Pack, Dim> widths = cpgimp_half_widths(grid, points, first);
  Vec<Dim> half;
  for (int a = 0; a < Dim; ++a) {
    std::array<double, pack_size> lane;
    widths[a].store(lane.data());
    half[a] = lane[p - first];
  }
  return half.asDiagonal();
}

template class Gimp<2>;
template class Gimp<3>;
template class Cpgimp<2>;
template class Cpgimp<3>;

} // namespace riedel
