#include "shapefunctions/cpdi2.hpp"

#include "core/base/pack_matrix.hpp"
#include "core/state/cell_place.hpp"
#include "shapefunctions/kit/corners.hpp"
#include "shapefunctions/kit/tensor_product.hpp"

namespace riedel {

namespace {

template <int Dim>
using CornerPlaces = std::array<PackVector<Dim>, power(2, Dim)>;

template <int Dim>
CornerPlaces<Dim> corners_of(const Points<Dim>& points, Index p) {
  CornerPlaces<Dim> x;
  for (int c = 0; c < power(2, Dim); ++c)
    for (int a = 0; a < Dim; ++a) x[c][a] = load_lanes(points.scheme_data[c * Dim + a], p, points.size());
  return x;
}

/// M_c = 2⁻ᵈ Π (1 + s_ca ξ_a) and ∂M_c/∂ξ_a at a Gauss point, ξ_a = s_ga/√3.
template <int Dim>
struct CornerShape {
  double value = 1.0;
  std::array<double, Dim> gradient;

  CornerShape(int c, int g) {
    constexpr double place = 0.57735026918962576451; // 1/√3
    gradient.fill(1.0);
    for (int a = 0; a < Dim; ++a) {
      const double factor = 0.5 * (1.0 + corner_sign(c, a) * corner_sign(g, a) * place);
      value *= factor;
      for (int b = 0; b < Dim; ++b) gradient[b] *= a == b ? 0.5 * corner_sign(c, a) : factor;
    }
  }
};

/// Weights of the corners of eight domains in the means over them.
template <int Dim>
struct CornerWeights {
  Pack volume{0.0};
  std::array<Pack, power(2, Dim)> value;
  CornerPlaces<Dim> gradient;
};

/// w_c = ∫ M_c dx/V and ∫ ∇M_c dx/V. Two points along each axis integrate both exactly: det J and its cofactors are at
/// most of second degree in each ξ_a, M_c is of first.
template <int Dim>
CornerWeights<Dim> corner_weights(const CornerPlaces<Dim>& x) {
  constexpr int corners = power(2, Dim);
  CornerWeights<Dim> w;
  w.value.fill(Pack(0.0));
  for (PackVector<Dim>& gradient : w.gradient) gradient.fill(Pack(0.0));
  for (int g = 0; g < corners; ++g) {
    PackMatrix<Dim> J; // J[a] = ∂x/∂ξ_a
    for (PackVector<Dim>& column : J) column.fill(Pack(0.0));
    for (int c = 0; c < corners; ++c)
      for (int a = 0; a < Dim; ++a)
        for (int i = 0; i < Dim; ++i) J[a][i] += Pack(CornerShape<Dim>(c, g).gradient[a]) * x[c][i];
    const PackMatrix<Dim> C = cofactor(J);
    Pack det(0.0);
    for (int i = 0; i < Dim; ++i) det += J[0][i] * C[0][i];
    w.volume += det;
    for (int c = 0; c < corners; ++c) {
      const CornerShape<Dim> M(c, g);
      w.value[c] += Pack(M.value) * det;
      for (int a = 0; a < Dim; ++a)
        for (int i = 0; i < Dim; ++i) w.gradient[c][i] += Pack(M.gradient[a]) * C[a][i];
    }
  }
  const Pack per_volume = Pack(1.0) / w.volume;
  for (int c = 0; c < corners; ++c) {
    w.value[c] *= per_volume;
    for (Pack& component : w.gradient[c]) component *= per_volume;
  }
  return w;
}

/// Σ_c w_c x_c, the centroid for positions.
template <int Dim>
PackVector<Dim> centroid(const CornerPlaces<Dim>& x, const CornerWeights<Dim>& w) {
  PackVector<Dim> middle;
  middle.fill(Pack(0.0));
  for (std::size_t c = 0; c < x.size(); ++c)
    for (int a = 0; a < Dim; ++a) middle[a] += w.value[c] * x[c][a];
  return middle;
}

/// Shortens domains whose corners are too far from their centres: the corners move inwards, and the domains are shifted
/// so that their centroids are unchanged.
template <int Dim>
struct LimitedCorners {
  CornerPlaces<Dim> place;
  CornerWeights<Dim> weights;
  Mask shortened;

  LimitedCorners(const CornerPlaces<Dim>& x, const PackVector<Dim>& middle, const Pack& longest) : place(x) {
    shortened = Pack(1.0) < Pack(0.0);
    for (PackVector<Dim>& corner : place) {
      PackVector<Dim> r;
      for (int a = 0; a < Dim; ++a) r[a] = corner[a] - middle[a];
      const Pack factor = shortening<Dim>(r, longest);
      shortened = shortened || factor < Pack(1.0);
      for (int a = 0; a < Dim; ++a) corner[a] = middle[a] + factor * r[a];
    }
    weights = corner_weights<Dim>(place);
    const PackVector<Dim> now = centroid<Dim>(place, weights);
    for (PackVector<Dim>& corner : place)
      for (int a = 0; a < Dim; ++a) corner[a] += middle[a] - now[a];
  }
};

/// Velocity of the grid at eight positions, by hats; zero off the grid.
template <int Dim>
PackVector<Dim> velocity_at(const Grid<Dim>& grid, const Nodes<Dim>& nodes, const PackVector<Dim>& x) {
  std::array<std::array<double, pack_size>, Dim> place, v{};
  for (int a = 0; a < Dim; ++a) x[a].store(place[a].data());
  for (int k = 0; k < pack_size; ++k) {
    Vec<Dim> at, sum = Vec<Dim>::Zero();
    for (int a = 0; a < Dim; ++a) at[a] = place[a][k];
    const CellPlace<Dim> cell(grid, at);
    if (!cell.inside()) continue;
    for (int n = 0; n < power(2, Dim); ++n) sum += cell.hat(n) * nodes.motion[cell.node(n)].velocity;
    for (int a = 0; a < Dim; ++a) v[a][k] = sum[a];
  }
  PackVector<Dim> answer;
  for (int a = 0; a < Dim; ++a) answer[a] = Pack::load(v[a].data());
  return answer;
}

/// Corners beyond their shortened domains may be outside the material, so they follow the point's motion, v_p + L_p
/// (x_c − x_p).
template <int Dim>
void move_shortened(const Grid<Dim>& grid, const Nodes<Dim>& nodes, const Points<Dim>& points, Index p, double limit,
                    const CornerPlaces<Dim>& x, CornerPlaces<Dim>& v) {
  const PackVector<Dim> middle = centroid<Dim>(x, corner_weights<Dim>(x));
  const LimitedCorners<Dim> limited(x, middle, Pack(limit * grid.cell.minCoeff()));
  CornerPlaces<Dim> near;
  for (int c = 0; c < power(2, Dim); ++c) near[c] = velocity_at<Dim>(grid, nodes, limited.place[c]);
  const PackVector<Dim> v_p = centroid<Dim>(near, limited.weights);
  for (int c = 0; c < power(2, Dim); ++c)
    for (int i = 0; i < Dim; ++i) {
      Pack whole = v_p[i];
      for (int j = 0; j < Dim; ++j)
        whole += load_lanes(points.velocity_gradient[i * Dim + j], p, points.size()) * (x[c][j] - middle[j]);
      v[c][i] = select(limited.shortened, whole, v[c][i]);
    }
}

} // namespace

template <int Dim>
void Cpdi2<Dim>::initialise(const Grid<Dim>&, Points<Dim>& points) const {
  for (Index p = 0; p < points.size(); ++p) {
    Mat<Dim> R = points.deformation_gradient_of(p);
    for (int a = 0; a < Dim; ++a) R.col(a) *= points.half_size[a][p];
    for (int c = 0; c < power(2, Dim); ++c) {
      Vec<Dim> x = points.position_of(p);
      for (int a = 0; a < Dim; ++a) x += corner_sign(c, a) * R.col(a);
      for (int a = 0; a < Dim; ++a) points.scheme_data[c * Dim + a][p] = x[a];
    }
  }
}

template <int Dim>
void Cpdi2<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                          Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    CornerPlaces<Dim> x = corners_of(points, p);
    CornerWeights<Dim> w = corner_weights<Dim>(x);
    if (limit_ > 0.0) {
      const LimitedCorners<Dim> limited(x, centroid<Dim>(x, w), Pack(limit_ * grid.cell.minCoeff()));
      x = limited.place;
      w = limited.weights;
    }
    const auto corner = [&](int c) {
      return Corner<Dim>{.place = x[c], .weight = w.value[c], .gradient = w.gradient[c]};
    };
    fill_corners<Dim>(grid, corner, w.volume > Pack(0.0), stencils.group_of(p));
  }
}

template <int Dim>
void Cpdi2<Dim>::move(const Grid<Dim>& grid, const Nodes<Dim>& nodes, double dt, Points<Dim>& points,
                      Range block) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    CornerPlaces<Dim> x = corners_of(points, p);
    CornerPlaces<Dim> v;
    for (int c = 0; c < power(2, Dim); ++c) v[c] = velocity_at<Dim>(grid, nodes, x[c]);
    if (limit_ > 0.0) move_shortened<Dim>(grid, nodes, points, p, limit_, x, v);
    for (int c = 0; c < power(2, Dim); ++c)
      for (int a = 0; a < Dim; ++a) {
        x[c][a] += Pack(dt) * v[c][a];
        x[c][a].store(points.scheme_data[c * Dim + a] + p);
      }
    const PackVector<Dim> middle = centroid<Dim>(x, corner_weights<Dim>(x));
    for (int a = 0; a < Dim; ++a) middle[a].store(points.position[a] + p);
  }
}

template <int Dim>
Corners<Dim> Cpdi2<Dim>::corners(const Grid<Dim>&, const Points<Dim>& points, Index p) const {
  Corners<Dim> x;
  for (int c = 0; c < power(2, Dim); ++c)
    for (int a = 0; a < Dim; ++a) x[c][a] = points.scheme_data[c * Dim + a][p];
  return x;
}

template class Cpdi2<2>;
template class Cpdi2<3>;

} // namespace riedel
