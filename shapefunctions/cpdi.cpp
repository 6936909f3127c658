#include "shapefunctions/cpdi.hpp"

#include "shapefunctions/kit/corners.hpp"
#include "shapefunctions/kit/tensor_product.hpp"

namespace riedel {

namespace {

/// Eight parallelograms (parallelepipeds): centres, half vectors R_a, and the rows of R⁻¹.
template <int Dim>
struct Domains {
  PackVector<Dim> centre;
  std::array<PackVector<Dim>, Dim> half, inverse; ///< half[a] = R_a; inverse[a]·R_b = δ_ab
};

/// r = (R_a × R_b) in space, and R_a rotated by −90° in the plane, both scaled.
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

/// Shortens the half diagonals l_c = Σ_a s_ca R_a; the R_a follow: R_a = 2⁻ᵈ Σ_c s_ca l_c.
template <int Dim>
void limit_diagonals(std::array<PackVector<Dim>, Dim>& R, const Pack& longest) {
  constexpr int corners = power(2, Dim);
  std::array<PackVector<Dim>, Dim> shorter;
  for (PackVector<Dim>& column : shorter) column.fill(Pack(0.0));
  for (int c = 0; c < corners; ++c) {
    PackVector<Dim> l;
    l.fill(Pack(0.0));
    for (int a = 0; a < Dim; ++a)
      for (int i = 0; i < Dim; ++i) l[i] += Pack(corner_sign(c, a)) * R[a][i];
    const Pack share = shortening<Dim>(l, longest) * Pack(1.0 / corners);
    for (int a = 0; a < Dim; ++a)
      for (int i = 0; i < Dim; ++i) shorter[a][i] += Pack(corner_sign(c, a)) * share * l[i];
  }
  R = shorter;
}

/// @param longest maximum half diagonal [m]; not positive: no limit
template <int Dim>
Domains<Dim> domains_of(const Points<Dim>& points, Index p, const Pack& longest) {
  const Index size = points.size();
  Domains<Dim> d;
  for (int a = 0; a < Dim; ++a) {
    d.centre[a] = load_lanes(points.position[a], p, size);
    const Pack half_size = load_lanes(points.half_size[a], p, size);
    for (int i = 0; i < Dim; ++i)
      d.half[a][i] = load_lanes(points.deformation_gradient[i * Dim + a], p, size) * half_size;
  }
  if (all(longest > Pack(0.0))) limit_diagonals<Dim>(d.half, longest);
  invert(d.half, d.inverse);
  return d;
}

/// Corner c of eight domains: N = 2⁻ᵈ Σ_c N_i(x_c) and ∇N = R⁻ᵀ 2⁻ᵈ Σ_c s_c N_i(x_c), where s_c = (±1, …) identifies
/// the corner; for a parallelogram these are eqs. (18) and (20) of the paper.
template <int Dim>
Corner<Dim> corner_of(const Domains<Dim>& domains, int c) {
  constexpr int corners = power(2, Dim);
  Corner<Dim> corner{.place = domains.centre, .weight = Pack(1.0 / corners), .gradient = {}};
  corner.gradient.fill(Pack(0.0));
  for (int a = 0; a < Dim; ++a) {
    const Pack s(corner_sign(c, a)), share(corner_sign(c, a) * (1.0 / corners));
    for (int i = 0; i < Dim; ++i) {
      corner.place[i] += s * domains.half[a][i];
      corner.gradient[i] += share * domains.inverse[a][i];
    }
  }
  return corner;
}

} // namespace

template <int Dim>
void Cpdi<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  const Pack longest(limit_ * grid.cell.minCoeff());
  for (Index p = block.begin; p < block.end; p += pack_size) {
    const Domains<Dim> domains = domains_of(points, p, longest);
    const auto corner = [&](int c) { return corner_of<Dim>(domains, c); };
    fill_corners<Dim>(grid, corner, Pack(0.0) <= Pack(0.0), stencils.group_of(p));
  }
}

template <int Dim>
Mat<Dim> Cpdi<Dim>::domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const {
  const Index first = p / pack_size * pack_size;
  const Domains<Dim> domains = domains_of(points, first, Pack(limit_ * grid.cell.minCoeff()));
  Mat<Dim> R;
  for (int a = 0; a < Dim; ++a)
    for (int i = 0; i < Dim; ++i) {
      std::array<double, pack_size> lane;
      domains.half[a][i].store(lane.data());
      R(i, a) = lane[p - first];
    }
  return R;
}

template class Cpdi<2>;
template class Cpdi<3>;

} // namespace riedel
