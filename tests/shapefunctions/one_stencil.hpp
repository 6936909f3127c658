/// The stencil of one point on a grid of four cells of one metre along each axis, node by node.
#pragma once

#include "support/problems.hpp"

namespace riedel::test {

/// N and ∇N: [0] = N, [1 + a] = ∂N/∂x_a.
template <int Dim>
using Weight = Eigen::Matrix<double, Dim + 1, 1>;

/// Four cells along each axis from the origin, with four more on every side.
template <int Dim>
Grid<Dim> four_cells() {
  Counts<Dim> cells;
  cells.fill(4);
  return grid_of<Dim>(cells, 1.0, 4);
}

/// By node, summed over entries.
template <int Dim>
std::vector<Weight<Dim>> weights(const std::string& name, const Vec<Dim>& x, double half_size,
                                 const Mat<Dim>& F = Mat<Dim>::Identity(), const Grid<Dim>& grid = four_cells<Dim>(),
                                 const std::map<std::string, Value>& options = {}) {
  Points<Dim> points;
  points.resize(1, 0);
  for (int a = 0; a < Dim; ++a) {
    points.position[a][0] = x[a];
    points.half_size[a][0] = half_size;
    for (int b = 0; b < Dim; ++b) points.deformation_gradient[a * Dim + b][0] = F(a, b);
  }
  const auto shape = scheme<Dim>(name, options);
  Stencils<Dim> stencils;
  stencils.resize(1, shape->max_nodes());
  Columns node_data{0};
  evaluate_anew(*shape, grid, points, node_data, stencils);
  std::vector<Weight<Dim>> all(static_cast<std::size_t>(grid.node_count()), Weight<Dim>::Zero());
  const StencilGroup<Dim>& group = stencils.group_of(0);
  for (int e = 0; e < group.count; ++e) {
    Weight<Dim>& w = all[static_cast<std::size_t>(group.node_of(e, 0))];
    w[0] += group.value_of(e, 0);
    for (int a = 0; a < Dim; ++a) w[a + 1] += group.gradient_of(e, a, 0);
  }
  return all;
}

template <int Dim>
double difference(const std::vector<Weight<Dim>>& A, const std::vector<Weight<Dim>>& B) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < A.size(); ++i) maximum = std::max(maximum, (A[i] - B[i]).cwiseAbs().maxCoeff());
  return maximum;
}

} // namespace riedel::test
