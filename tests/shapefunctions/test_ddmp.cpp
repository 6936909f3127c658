/// The dual domain method's gradients: continuous, those of nodal averages in the interior, zero where there is no
/// mass.
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// A block of points, two per cell and direction, in the four cells, and the stencils of any point in it.
template <int Dim>
struct Block {
  Grid<Dim> grid = four_cells<Dim>();
  Points<Dim> points;
  std::shared_ptr<const ShapeFunction<Dim>> shape;
  Columns node_data{0};
  double low;

  /// @param from where the block begins along the first axis [m]
  explicit Block(double alpha = 0.5, double from = 0.0) : shape(scheme<Dim>("ddmp", {{"alpha", alpha}})), low(from) {
    Counts<Dim> cells;
    cells.fill(4);
    fill<Dim>(points, cells, 1.0, 2, 1.0, 0, [](const Vec<Dim>&) { return true; });
    for (Index p = 0; p < points.size(); ++p) points.position[0][p] += from;
    node_data = Columns(shape->node_data_size());
    node_data.resize(grid.node_count());
    shape->prepare(grid, points, node_data);
  }

  [[nodiscard]] std::vector<Weight<Dim>> weights_at(const Vec<Dim>& x) const {
    Points<Dim> one;
    one.resize(1, 0);
    for (int a = 0; a < Dim; ++a) one.position[a][0] = x[a];
    Stencils<Dim> stencils;
    stencils.resize(1, shape->max_nodes());
    stencils.node_data = &node_data;
    shape->evaluate(grid, one, {0, 1}, stencils);
    std::vector<Weight<Dim>> all(static_cast<std::size_t>(grid.node_count()), Weight<Dim>::Zero());
    const StencilGroup<Dim>& group = stencils.group_of(0);
    for (int e = 0; e < group.count; ++e) {
      Weight<Dim>& w = all[static_cast<std::size_t>(group.node_of(e, 0))];
      w[0] += group.value_of(e, 0);
      for (int a = 0; a < Dim; ++a) w[1 + a] += group.gradient_of(e, a, 0);
    }
    return all;
  }
};

template <int Dim>
double jump_across_faces(const Block<Dim>& block) {
  const double step = 1e-9;
  double maximum = 0.0;
  for (int a = 0; a < Dim; ++a)
    for (const double face : {1.0, 2.0, 3.0}) {
      Vec<Dim> x = Vec<3>(0.3, 1.7, 2.6).head<Dim>();
      x[a] = face;
      const Vec<Dim> d = step * Vec<Dim>::Unit(a);
      maximum = std::max(maximum, difference<Dim>(block.weights_at(x - d), block.weights_at(x + d)));
    }
  return maximum;
}

TEST(Ddmp, HasAGradientThatIsContinuousAcrossFaces) {
  EXPECT_LT(jump_across_faces(Block<2>()), 1e-7);
  EXPECT_LT(jump_across_faces(Block<3>()), 1e-7);
  EXPECT_LT(jump_across_faces(Block<2>(0.5, 0.37)), 1e-7) << "with cells that are filled in part";
}

/// On a node ∇̃S is that node's average: (−1/2, 0, 1/2)/h along one axis times (1, 4, 1)/6 along the other.
TEST(Ddmp, TakesTheMeshsAverageAroundANodeInTheInterior) {
  const Block<2> block;
  const auto w = block.weights_at({2.0, 2.0});
  const auto gradient = [&](Index i, Index j) { return w[static_cast<std::size_t>(block.grid.node({i, j}))][1]; };
  for (const Index side : {-1, 1}) {
    EXPECT_NEAR(gradient(6 + side, 6), side * 0.5 * 4.0 / 6.0, 1e-14);
    EXPECT_NEAR(gradient(6 + side, 7), side * 0.5 / 6.0, 1e-14);
  }
  EXPECT_NEAR(gradient(6, 6), 0.0, 1e-14);
}

/// In a cell's middle the mean of four nodes' averages, and α of the hats' own gradient.
TEST(Ddmp, MixesBothGradientsByAlphaInTheMiddleOfACell) {
  const auto gradient = [](double alpha) {
    const Block<2> block(alpha);
    const auto w = block.weights_at({1.5, 1.5});
    return Vec<2>(w[static_cast<std::size_t>(block.grid.node({6, 6}))][1],
                  w[static_cast<std::size_t>(block.grid.node({7, 6}))][1]);
  };
  EXPECT_LT((gradient(1.0) - Vec<2>(0.5, 0.0)).norm(), 1e-14) << "the hats' own";
  const double mean = 0.25 * 0.5 * (4.0 + 1.0) / 6.0; // from each of two nodes, in both of their rows
  EXPECT_LT((gradient(0.0) - Vec<2>(mean, mean)).norm(), 1e-14);
  EXPECT_LT((gradient(0.5) - 0.5 * (gradient(0.0) + gradient(1.0))).norm(), 1e-14);
}

/// Forces must not act where there is no mass: momentum would be lost there.
template <int Dim>
void nodes_with_a_gradient_have_mass(double from) {
  const Block<Dim> block(0.5, from);
  std::vector<double> mass(static_cast<std::size_t>(block.grid.node_count()), 0.0), gradient = mass;
  for (Index p = 0; p < block.points.size(); ++p) {
    const auto w = block.weights_at(block.points.position_of(p));
    for (std::size_t i = 0; i < w.size(); ++i) {
      mass[i] += w[i][0];
      gradient[i] += w[i].template tail<Dim>().norm();
    }
  }
  double outermost = 0.0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (mass[i] == 0.0) {
      EXPECT_EQ(gradient[i], 0.0);
    } else {
      outermost = std::max(outermost, gradient[i] / mass[i]);
    }
  }
  EXPECT_LT(outermost, 20.0) << "and no more than a share that goes with the mass";
}

TEST(Ddmp, GivesForcesOnlyToNodesThatHaveMass) {
  for (const double from : {0.0, 0.2, 0.24}) {
    nodes_with_a_gradient_have_mass<2>(from);
    nodes_with_a_gradient_have_mass<3>(from);
  }
}

/// A point that enters an empty cell changes the gradients of the others smoothly.
TEST(Ddmp, FillsACellSmoothly) {
  const auto gradients = [](double from) { return Block<2>(0.5, from).weights_at({1.3, 2.2}); };
  const double edge = 0.25; // the outermost points stand on a face
  EXPECT_LT(difference<2>(gradients(edge - 1e-8), gradients(edge + 1e-8)), 1e-6);
}

} // namespace
} // namespace riedel::test
