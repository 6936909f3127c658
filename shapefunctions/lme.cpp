#include "shapefunctions/lme.hpp"

#include "shapefunctions/kit/tensor_product.hpp"
#include "shapefunctions/kit/wall_ends.hpp"

namespace riedel {

namespace {

constexpr int nodes_in_row = 6;
constexpr int below = 2; ///< number of nodes in the row before the point's cell
using Row = std::array<Pack, nodes_in_row>;

/// Nodes of a row, relative to the lower one of the point's cell: a = −2 … 3.
Pack number_of(int i) { return Pack(static_cast<double>(i - below)); }

/// Weights, their mean and their variance; the mean relative to a nearby node, so that both are exact there, too.
struct Weights {
  Row N;
  Pack mean, variance;
};

/// N_a ∝ c_a exp(θ a)
/// @param nearest node relative to which the mean is given
Weights tilted(const Row& c, const Pack& theta, const Pack& nearest) {
  const Pack w = exp(theta), per_w = Pack(1.0) / w, ww = w * w;
  Weights tilt{.N = {c[0] * per_w * per_w, c[1] * per_w, c[2], c[3] * w, c[4] * ww, c[5] * ww * w},
               .mean = Pack(0.0),
               .variance = Pack(0.0)};
  Pack sum(0.0);
  for (const Pack& N : tilt.N) sum += N;
  const Pack per_sum = Pack(1.0) / sum;
  for (int i = 0; i < nodes_in_row; ++i) {
    tilt.N[i] = tilt.N[i] * per_sum;
    tilt.mean += (number_of(i) - nearest) * tilt.N[i];
  }
  for (int i = 0; i < nodes_in_row; ++i) {
    const Pack d = number_of(i) - nearest - tilt.mean;
    tilt.variance += tilt.N[i] * d * d;
  }
  return tilt;
}

/// Because nodes form rows, the least biased function is the product of the least biased functions along the axes. One
/// axis: N_a ∝ exp(−γ (s − a)² + λ (s − a)) = c_a exp(θ a) up to a common factor, with c_a = exp(−γ a²), and the mean
/// of a must be s, the position in the cell.
std::array<ValueGradient<Pack>, nodes_in_row> least_biased(const Pack& place, const Axis& axis, double gamma,
                                                           const Row& fading, int newton_steps) {
  const Pack s = place - Pack(static_cast<double>(below)), cell = axis.first + Pack(static_cast<double>(below));
  const Pack first_wall(axis.walls.first), last_wall(axis.walls.last);
  Row c;
  for (int i = 0; i < nodes_in_row; ++i) {
    const Pack node = cell + number_of(i);
    c[i] = select(node >= first_wall && node <= last_wall, fading[i], Pack(0.0));
  }
  // Start: λ = 0, or next to a wall, the solution for the cell's two nodes only.
  const Pack alone = log(s / (Pack(1.0) - s)) + Pack(gamma);
  Pack theta = Pack(2 * gamma) * s;
  theta = select(cell <= first_wall, min(theta, alone), theta);
  theta = select(cell + Pack(1.0) >= last_wall, max(theta, alone), theta);

  const Pack nearest = select(s < Pack(0.5), Pack(0.0), Pack(1.0));
  Weights weights = tilted(c, theta, nearest);
  for (int i = 0; i < newton_steps; ++i) {
    theta += (s - nearest - weights.mean) / weights.variance;
    weights = tilted(c, theta, nearest);
  }
  std::array<ValueGradient<Pack>, nodes_in_row> factor;
  const Pack scale = axis.per_h / weights.variance;
  for (int i = 0; i < nodes_in_row; ++i)
    factor[i] = {.value = weights.N[i], .gradient = weights.N[i] * (number_of(i) - nearest - weights.mean) * scale};
  return factor;
}

} // namespace

template <int Dim>
const Keys& Lme<Dim>::parameters() {
  static const Keys keys{
      {"gamma", 1.8, "-", between(1.5, 4), "lme: decay of weights, exp(−γ (distance/cell)²); 4 is close to hats"}};
  return keys;
}

template <int Dim>
Lme<Dim>::Lme(const Values& options) : gamma_(options.number("gamma")) {
  for (int i = 0; i < nodes_in_row; ++i) fading_[i] = std::exp(-gamma_ * square(i - below));
}

template <int Dim>
void Lme<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  const int newton_steps = gamma_ <= 1.8 ? 3 : gamma_ <= 3 ? 5 : 6; // to round-off, at walls and away from them
  const Row fading{fading_[0], fading_[1], fading_[2], fading_[3], fading_[4], fading_[5]};
  const auto function = [&](const Pack& s, const Axis& axis) {
    return least_biased(s, axis, gamma_, fading, newton_steps);
  };
  for (Index p = block.begin; p < block.end; p += pack_size) {
    std::array<AxisLanes, Dim> lanes;
    for (int a = 0; a < Dim; ++a)
      lanes[a] = {.position = before_walls(grid, a, load_lanes(points.position[a], p, points.size())),
                  .half_width = Pack(below * grid.cell[a])};
    fill_tensor_product<Dim, nodes_in_row>(grid, lanes, stencils.group_of(p), function);
  }
}

template class Lme<2>;
template class Lme<3>;

} // namespace riedel
