#include "shapefunctions/cpdi.hpp"

#include "core/state/cell_place.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

/// Weights of one point, added corner by corner: N = 2⁻ᵈ Σ_c N_i(x_c) and ∇N = R⁻ᵀ 2⁻ᵈ Σ_c s_c N_i(x_c), where the
/// columns of R are the domain's half vectors and s_c = (±1, …) tells the corner; for a parallelogram these are
/// eqs. (18) and (20) of the paper.
template <int Dim>
class CornerSum {
public:
  CornerSum(const Grid<Dim>& grid, StencilGroup<Dim>& group, int lane) : grid_(grid), group_(group), lane_(lane) {}

  void add(const Vec<Dim>& x, const Mat<Dim>& R) {
    const Mat<Dim> R_inverse_transposed = R.inverse().transpose();
    for (int c = 0; c < power(2, Dim); ++c) {
      Vec<Dim> s;
      for (int a = 0; a < Dim; ++a) s[a] = (c >> a) & 1 ? 1.0 : -1.0;
      add_corner(c, x + R * s, R_inverse_transposed * s / power(2, Dim));
    }
  }

private:
  void add_corner(int corner, const Vec<Dim>& x, const Vec<Dim>& weight_of_slope) {
    const CellPlace<Dim> place(grid_, x);
    if (!place.inside()) {
      group_.lost[lane_] = true;
      return;
    }
    group_.lowest_row = std::min(group_.lowest_row, place.row());
    group_.highest_row = std::max(group_.highest_row, place.row() + 1);
    for (int n = 0; n < power(2, Dim); ++n) {
      const int entry = corner * power(2, Dim) + n, at = entry * pack_size + lane_;
      const double N = place.hat(n);
      group_.node[at] = place.node(n);
      group_.value[at] = N / power(2, Dim);
      for (int a = 0; a < Dim; ++a) group_.slope[(entry * Dim + a) * pack_size + lane_] = N * weight_of_slope[a];
    }
  }

  const Grid<Dim>& grid_;
  StencilGroup<Dim>& group_;
  const int lane_;
};

} // namespace

template <int Dim>
void Cpdi<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    StencilGroup<Dim>& group = stencils.group_of(p);
    group.count = max_nodes();
    group.lost.fill(false);
    group.lowest_row = grid.nodes[Dim - 1];
    group.highest_row = 0;
    for (int k = 0; k < pack_size; ++k) {
      const Index q = std::min(p + k, points.size() - 1);
      CornerSum<Dim>(grid, group, k).add(points.position_of(q), domain(grid, points, q));
    }
    group.drop_lost_lanes();
  }
}

template <int Dim>
Mat<Dim> Cpdi<Dim>::domain(const Grid<Dim>&, const Points<Dim>& points, Index p) const {
  Mat<Dim> R = points.deformation_gradient_of(p);
  for (int a = 0; a < Dim; ++a) R.col(a) *= points.half_size[a][p];
  return R;
}

template class Cpdi<2>;
template class Cpdi<3>;

} // namespace riedel
