#include "shapefunctions/gimp.hpp"

#include "shapefunctions/tensor_product.hpp"

#include <Eigen/Eigenvalues>

namespace riedel {

namespace {

/// The hat averaged over [r − l, r + l], l ≤ h: Bardenhagen & Kober (2004), eq. (44). The paper's cases by |r| are one
/// expression in the hat and its integral at the two ends, which also holds for boxes wider than a cell (l > h/2).
template <class Real>
ValueSlope<Real> gimp(Real r, Real h, Real l) {
  const Real a = max(min(r - l, h), -h), b = max(min(r + l, h), -h); // the ends, inside the hat's support
  const auto integral = [&](Real s) { return s - copysign(s * s, s) / (h + h); };
  const auto hat = [&](Real s) { return Real(1.0) - abs(s) / h; };
  const Real width = l + l;
  return {.value = (integral(b) - integral(a)) / width, .slope = (hat(b) - hat(a)) / width};
}

/// Diagonal of U = √(FᵀF). In two dimensions U = (FᵀF + det F I)/tr U with tr U = √(tr FᵀF + 2 det F).
template <int Dim>
Vec<Dim> stretch_diagonal(const Mat<Dim>& F) {
  const Mat<Dim> C = F.transpose() * F;
  if constexpr (Dim == 2) {
    const double J = F.determinant();
    return (C.diagonal().array() + J) / std::sqrt(C.trace() + 2 * J);
  } else {
    return Eigen::SelfAdjointEigenSolver<Mat<Dim>>(C).operatorSqrt().diagonal();
  }
}

template <int Dim>
Vec<Dim> cpgimp_half_width(const Grid<Dim>& grid, const Points<Dim>& points, Index p) {
  const Vec<Dim> stretch = stretch_diagonal<Dim>(points.deformation_gradient_of(p));
  Vec<Dim> l;
  for (int a = 0; a < Dim; ++a) l[a] = std::min(points.half_size[a][p] * stretch[a], grid.cell[a]);
  return l;
}

} // namespace

template <int Dim>
void Gimp<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    std::array<AxisLanes, Dim> lanes;
    for (int a = 0; a < Dim; ++a)
      lanes[a] = {.position = load_lanes(points.position[a], p, points.size()),
                  .half_width = Pack(grid.stretch[a]) * load_lanes(points.half_size[a], p, points.size())};
    fill_tensor_product<Dim>(grid, lanes, 3, stencils.group_of(p), gimp<Pack>);
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
    std::array<std::array<double, pack_size>, Dim> width;
    for (Index k = 0; k < pack_size; ++k) {
      const Vec<Dim> l = cpgimp_half_width(grid, points, std::min(p + k, points.size() - 1));
      for (int a = 0; a < Dim; ++a) width[a][k] = l[a];
    }
    std::array<AxisLanes, Dim> lanes;
    bool small = true; // no box wider than a cell: three nodes along each axis are enough
    for (int a = 0; a < Dim; ++a) {
      lanes[a] = {.position = load_lanes(points.position[a], p, points.size()),
                  .half_width = Pack::load(width[a].data())};
      small = small && all(lanes[a].half_width <= Pack(0.5 * grid.cell[a]));
    }
    fill_tensor_product<Dim>(grid, lanes, small ? 3 : 4, stencils.group_of(p), gimp<Pack>);
  }
}

template <int Dim>
Mat<Dim> Cpgimp<Dim>::domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const {
  return cpgimp_half_width(grid, points, p).asDiagonal();
}

template class Gimp<2>;
template class Gimp<3>;
template class Cpgimp<2>;
template class Cpgimp<3>;

} // namespace riedel
