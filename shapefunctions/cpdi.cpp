#include "shapefunctions/cpdi.hpp"

#include "shapefunctions/tensor_product.hpp"

namespace riedel {

namespace {

template <int Dim>
using PackVector = std::array<Pack, Dim>;

/// Eight parallelograms (parallelepipeds): centres, half vectors R_a, and the rows of R⁻¹.
template <int Dim>
struct Domains {
  PackVector<Dim> centre;
  std::array<PackVector<Dim>, Dim> half, inverse; ///< half[a] = R_a; inverse[a]·R_b = δ_ab
};

/// r = (R_a × R_b) in space, and R_a turned by −90° in the plane, both scaled.
void invert(const std::array<PackVector<2>, 2>& R, std::array<PackVector<2>, 2>& inverse) {
  const Pack per_det = Pack(1.0) / (R[0][0] * R[1][1] - R[0][1] * R[1][0]);
  inverse[0] = {R[1][1] * per_det, -R[1][0] * per_det};
  inverse[1] = {-R[0][1] * per_det, R[0][0] * per_det};
}
void invert(const std::array<PackVector<3>, 3>& R, std::array<PackVector<3>, 3>& inverse) {
  const auto cross = [](const PackVector<3>& a, const PackVector<3>& b) -> PackVector<3> {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  for (int a = 0; a < 3; ++a) inverse[a] = cross(R[(a + 1) % 3], R[(a + 2) % 3]);
  const Pack per_det = Pack(1.0) / (R[0][0] * inverse[0][0] + R[0][1] * inverse[0][1] + R[0][2] * inverse[0][2]);
  for (PackVector<3>& row : inverse)
    for (Pack& component : row) component *= per_det;
}

template <int Dim>
Domains<Dim> domains_of(const Points<Dim>& points, Index p) {
  const Index size = points.size();
  Domains<Dim> d;
  for (int a = 0; a < Dim; ++a) {
    d.centre[a] = load_lanes(points.position[a], p, size);
    const Pack half_size = load_lanes(points.half_size[a], p, size);
    for (int i = 0; i < Dim; ++i)
      d.half[a][i] = load_lanes(points.deformation_gradient[i * Dim + a], p, size) * half_size;
  }
  invert(d.half, d.inverse);
  return d;
}

/// Where the corners of eight domains lie.
struct Reach {
  Pack lowest, highest; ///< index along the last axis of the nodes
  Mask inside;          ///< whether all are on the grid
};

/// Weights of eight points, corner by corner: N = 2⁻ᵈ Σ_c N_i(x_c) and ∇N = R⁻ᵀ 2⁻ᵈ Σ_c s_c N_i(x_c), where s_c = (±1,
/// …) tells the corner; for a parallelogram these are eqs. (18) and (20) of the paper.
template <int Dim>
void add_corner(const Grid<Dim>& grid, const Domains<Dim>& domains, int corner, const StencilEntries<Dim>& entries,
                Reach& reach) {
  constexpr int corners = power(2, Dim);
  PackVector<Dim> x = domains.centre, weight_of_slope;
  weight_of_slope.fill(Pack(0.0));
  for (int a = 0; a < Dim; ++a) {
    const Pack s((corner >> a) & 1 ? 1.0 : -1.0), share((corner >> a) & 1 ? 1.0 / corners : -1.0 / corners);
    for (int i = 0; i < Dim; ++i) {
      x[i] += s * domains.half[a][i];
      weight_of_slope[i] += share * domains.inverse[a][i];
    }
  }

  PackVector<Dim> xi; // place in the corner's cell, 0 to 1
  const Counts<Dim> strides = grid.strides();
  Pack base(0.0), row;
  for (int a = 0; a < Dim; ++a) {
    const Pack place = (x[a] - Pack(grid.origin[a])) * Pack(1.0 / grid.cell[a]), lowest = floor(place);
    const Mask fits = lowest >= Pack(0.0) && lowest <= Pack(grid.nodes[a] - 2); // false for NaN too
    xi[a] = place - lowest;
    row = select(fits, lowest, Pack(0.0));
    base += row * Pack(strides[a]);
    reach.inside = reach.inside && fits;
  }
  reach.lowest = min(reach.lowest, row);
  reach.highest = max(reach.highest, row + Pack(1.0));

  entries.set_base(corner, whole_numbers(base));
  for (int n = 0; n < corners; ++n) {
    const int entry = corner * corners + n;
    Pack N(1.0);
    for (int a = 0; a < Dim; ++a) N *= (n >> a) & 1 ? xi[a] : Pack(1.0) - xi[a];
    entries.set_value(entry, N * Pack(1.0 / corners));
    for (int a = 0; a < Dim; ++a) entries.set_slope(entry, a, N * weight_of_slope[a]);
  }
}

/// The nodes of a corner's cell are a patch.
template <int Dim>
void set_patches(const Grid<Dim>& grid, StencilGroup<Dim>& group) {
  const Counts<Dim> strides = grid.strides();
  group.count = power(4, Dim);
  group.shape = {power(2, Dim - 1), 2};
  for (int r = 0; r < group.shape.rows; ++r) group.row[r] = (r & 1) * strides[1] + (r >> 1) * strides[Dim - 1];
}

} // namespace

template <int Dim>
void Cpdi<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    StencilGroup<Dim>& group = stencils.group_of(p);
    set_patches(grid, group);
    const Domains<Dim> domains = domains_of(points, p);
    Reach reach{.lowest = Pack(grid.nodes[Dim - 1]), .highest = Pack(0.0), .inside = Pack(0.0) <= Pack(0.0)};
    for (int corner = 0; corner < power(2, Dim); ++corner) add_corner<Dim>(grid, domains, corner, group, reach);
    group.lowest = whole_numbers(reach.lowest);
    group.highest = whole_numbers(reach.highest);
    group.keep_lanes(reach.inside);
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
