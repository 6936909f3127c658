/// Local maximum entropy functions against the definition that they are solved from.
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// Σ_i N_i ln N_i + γ Σ_i N_i |x − x_i|²/h², which the functions minimise.
double bias(const std::vector<Weight<2>>& weights, const Vec<2>& x, double gamma, const Grid<2>& grid) {
  double sum = 0.0;
  for (Index i = 0; i < grid.node_count(); ++i) {
    const double N = weights[static_cast<std::size_t>(i)][0];
    if (N > 0.0) sum += N * std::log(N) + gamma * N * (x - grid.position(grid.index(i))).squaredNorm();
  }
  return sum;
}

/// Along x, with a wall at the node row of the lower corner of cell 0.
Grid<2> with_a_wall() {
  Grid<2> grid = four_cells<2>();
  grid.walls[0].first = 4;
  return grid;
}

class LeastBias : public testing::TestWithParam<double> {};

/// Moving weight between three nodes in a row, as linear fields allow it, increases the sum by second order.
TEST_P(LeastBias, NoOtherWeightsWithTheSameLinearFieldsAreLessBiased) {
  const double gamma = GetParam();
  for (const Grid<2>& grid : {four_cells<2>(), with_a_wall()})
    for (const Vec<2>& x : {Vec<2>(0.3, 1.7), Vec<2>(0.04, 2.0), Vec<2>(1.5, 1.5), Vec<2>(2.999, 0.5)}) {
      const auto N = weights<2>("lme", x, 0.25, Mat<2>::Identity(), grid, {{"gamma", gamma}});
      const double minimum = bias(N, x, gamma, grid);
      for (Index row = 4; row <= 7; ++row)
        for (Index first = 4; first <= 6; ++first)
          for (const double share : {1e-5, -1e-5}) {
            auto other = N;
            for (Index k = 0; k < 3; ++k)
              other[static_cast<std::size_t>(grid.node({first + k, row}))][0] += (k == 1 ? -2 : 1) * share;
            bool allowed = true;
            for (const Weight<2>& w : other) allowed = allowed && w[0] >= 0.0;
            if (allowed) { EXPECT_GT(bias(other, x, gamma, grid), minimum) << x.transpose() << ", node " << first; }
          }
    }
}

/// Newton's method has converged, wherever the point lies: next to a wall, on it, and in a single cell between two.
TEST_P(LeastBias, LinearFieldsAreExactEverywhere) {
  for (const Index last : {5, 6, 8}) {
    Grid<2> grid = four_cells<2>();
    grid.walls[0] = {.first = 4, .last = last};
    for (const double r : {0.0, 1e-9, 1e-5, 0.01, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 0.99, 1 - 1e-9, 1.0})
      for (const double x : {r, last - 5 + r}) {
        const auto N = weights<2>("lme", {x, 1.3}, 0.25, Mat<2>::Identity(), grid, {{"gamma", GetParam()}});
        double mean = 0.0, gradient = 0.0;
        for (Index i = 0; i < grid.node_count(); ++i) {
          mean += N[static_cast<std::size_t>(i)][0] * grid.position(grid.index(i))[0];
          gradient += N[static_cast<std::size_t>(i)][1] * grid.position(grid.index(i))[0];
        }
        EXPECT_NEAR(mean, x, 2e-11) << x << ", last wall " << last; // a point on a wall is drawn to this side by 1e-11
        EXPECT_NEAR(gradient, 1.0, 1e-12) << x << ", last wall " << last;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Gamma, LeastBias, testing::Values(1.5, 1.8, 2.2, 3.0, 3.5, 4.0));

TEST(Lme, HasGaussiansOverTheirSumInTheMiddleOfACell) {
  const auto N = weights<2>("lme", {1.5, 1.5}, 0.25);
  double sum = 0.0;
  for (const double r : {0.5, 1.5, 2.5}) sum += 2 * std::exp(-1.8 * r * r);
  const double nearest = std::exp(-1.8 * 0.25) / sum;
  EXPECT_NEAR(N[static_cast<std::size_t>(four_cells<2>().node({5, 5}))][0], nearest * nearest, 1e-15);
}

TEST(Lme, ComesNearToHatsAsGammaGrows) {
  const auto lies = [](double gamma) {
    return difference<2>(weights<2>("lme", {1.3, 1.4}, 0.25, Mat<2>::Identity(), four_cells<2>(), {{"gamma", gamma}}),
                         weights<2>("linear", {1.3, 1.4}, 0.25));
  };
  EXPECT_LT(lies(4.0), 0.5 * lies(1.5));
}

/// Nodes leave and enter the stencil when a point changes its cell: with the weight that they would have beyond it.
TEST(Lme, JumpsLittleWhereNodesEnterTheStencil) {
  const double step = 1e-9;
  for (const double gamma : {1.5, 1.8}) {
    const auto at = [&](double x) {
      return weights<2>("lme", {x, 1.5}, 0.25, Mat<2>::Identity(), four_cells<2>(), {{"gamma", gamma}});
    };
    EXPECT_LT(difference<2>(at(2.0 - step), at(2.0 + step)), 8 * std::exp(-9 * gamma) + 10 * step) << gamma;
  }
}

} // namespace
} // namespace riedel::test
