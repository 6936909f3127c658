/// What every registered scheme must satisfy, in two and three dimensions.
#include "support/problems.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <set>

namespace riedel::test {
namespace {

/// Points spread over a grid, on faces and nodes too, with deformed domains.
template <int Dim>
struct Cloud {
  Grid<Dim> grid = grid_of<Dim>(cells(), 0.5, 4);
  Points<Dim> points;
  Columns node_data{0};
  Stencils<Dim> stencils;
  std::shared_ptr<const ShapeFunction<Dim>> shape;

  static Counts<Dim> cells() {
    Counts<Dim> c;
    c.fill(3);
    return c;
  }

  /// @param walls whether the box of points lies between walls
  Cloud(const std::string& name, double share_of_cell, double deformation, Index count = 203, bool walls = false)
      : shape(scheme<Dim>(name)) {
    grid.cell[0] = 0.4; // cells need not be square
    grid.origin[0] = -4 * grid.cell[0];
    if (walls) grid.walls.fill({.first = 4, .last = 7});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    points.resize(count, 0);
    for (Index p = 0; p < count; ++p) {
      for (int a = 0; a < Dim; ++a) {
        const double x = 3.0 * unit(random);
        const double snapped = p % 5 == 0 ? std::round(x) : p % 5 == 1 ? std::round(2 * x) / 2 : x; // nodes, midpoints
        points.position[a][p] = snapped * grid.cell[a];
        points.half_size[a][p] = share_of_cell * grid.cell[a];
      }
      for (int c = 0; c < Dim * Dim; ++c) points.deformation_gradient[c][p] += deformation * (2.0 * unit(random) - 1.0);
    }
    stencils.resize(count, shape->max_nodes());
    evaluate();
  }

  void evaluate() { evaluate_anew(*shape, grid, points, node_data, stencils); }

  /// Σ_entries f(N, ∇N, x_i) of point p.
  template <class T, class F>
  T sum(Index p, T start, const F& f) const {
    const StencilGroup<Dim>& group = stencils.group_of(p);
    const int lane = p % pack_size;
    for (int e = 0; e < group.count; ++e) {
      Vec<Dim> gradient;
      for (int a = 0; a < Dim; ++a) gradient[a] = group.gradient[(e * Dim + a) * pack_size + lane];
      start += f(group.value_of(e, lane), gradient, grid.position(grid.index(group.node_of(e, lane))));
    }
    return start;
  }
};

/// Smallest eigenvalue of Σ_i N_ip (x_i − x_p) ⊗ (x_i − x_p), lengths in cells, over points on nodes and anywhere.
template <int Dim>
double min_second_moment(const std::string& name) {
  const Cloud<Dim> cloud(name, 0.25, 0.3);
  double minimum = 1e300;
  for (Index p = 0; p < cloud.points.size(); ++p) {
    const Mat<Dim> D = cloud.template sum<Mat<Dim>>(
        p, Mat<Dim>::Zero(), [&](double N, const Vec<Dim>&, const Vec<Dim>& x) -> Mat<Dim> {
          const Vec<Dim> r = (x - cloud.points.position_of(p)).cwiseQuotient(cloud.grid.cell);
          return N * r * r.transpose();
        });
    minimum = std::min(minimum, Eigen::SelfAdjointEigenSolver<Mat<Dim>>(D).eigenvalues()[0]);
  }
  return minimum;
}

/// The matrix that APIC inverts.
template <int Dim>
void a_scheme_that_spreads_points_has_second_moments(const std::string& name) {
  if (scheme<Dim>(name)->supports_affine()) {
    EXPECT_GT(min_second_moment<Dim>(name), 0.02);
  } else {
    EXPECT_LT(min_second_moment<Dim>(name), 1e-9);
  }
}

template <int Dim>
void weights_sum_to_one(const std::string& name, bool walls) {
  const Cloud<Dim> cloud(name, 0.5, 0.3, 203, walls);
  for (Index p = 0; p < cloud.points.size(); ++p) {
    EXPECT_NEAR(cloud.sum(p, 0.0, [](double N, auto&, auto) { return N; }), 1.0, 1e-14);
    const Vec<Dim> gradients =
        cloud.sum(p, Vec<Dim>(Vec<Dim>::Zero()), [](double, const Vec<Dim>& dN, auto) { return dN; });
    EXPECT_LT(gradients.norm(), 1e-12);
  }
}

template <int Dim>
void linear_fields_are_exact(const std::string& name, bool walls) {
  const double tolerance = walls ? 1e-11 : 1e-14; // points on a wall may be taken to lie a bit to this side of it
  const Cloud<Dim> cloud(name, 0.5, 0.3, 203, walls);
  for (Index p = 0; p < cloud.points.size(); ++p) {
    const Vec<Dim> x = cloud.sum(p, Vec<Dim>(Vec<Dim>::Zero()),
                                 [](double N, auto&, const Vec<Dim>& x_i) { return Vec<Dim>(N * x_i); });
    EXPECT_LT((x - cloud.points.position_of(p)).norm(), tolerance) << "point " << p;
    const Mat<Dim> gradient =
        cloud.sum(p, Mat<Dim>(Mat<Dim>::Zero()),
                  [](double, const Vec<Dim>& dN, const Vec<Dim>& x_i) { return Mat<Dim>(x_i * dN.transpose()); });
    EXPECT_LT((gradient - Mat<Dim>::Identity()).norm(), 1e-12) << "point " << p;
  }
}

/// With the whole domain inside one cell, where hats are multilinear, ∇N is the derivative of N for any scheme; in
/// three dimensions the hats' cubic term affects an inclined domain, so there the domains are axis-aligned. The centres
/// of cells, where splines of second degree have their knots, are left out.
template <int Dim>
void gradients_match_difference_quotients(const std::string& name) {
  constexpr double step = 1e-5;
  Cloud<Dim> cloud(name, 0.1, Dim == 2 ? 0.3 : 0.0);
  for (Index p = 0; p < cloud.points.size(); ++p)
    for (int a = 0; a < Dim; ++a) {
      const double place = cloud.points.position[a][p] / cloud.grid.cell[a];
      cloud.points.position[a][p] = (std::floor(place) + 0.3 + 0.39 * (place - std::floor(place))) * cloud.grid.cell[a];
    }
  const Columns places = cloud.points.position;
  for (int a = 0; a < Dim; ++a) {
    std::array<std::vector<std::vector<double>>, 3> weights; // by node, at −step, 0, +step; [2] holds gradients
    for (const int side : {0, 1, 2}) {
      cloud.points.position = places;
      for (Index p = 0; p < places.size(); ++p) cloud.points.position[a][p] += (side - 1) * step;
      cloud.evaluate();
      for (Index p = 0; p < places.size(); ++p) {
        std::vector<double> at_node(static_cast<std::size_t>(cloud.grid.node_count()), 0.0);
        const StencilGroup<Dim>& group = cloud.stencils.group_of(p);
        for (int e = 0; e < group.count; ++e)
          at_node[static_cast<std::size_t>(group.node_of(e, p % pack_size))] +=
              side == 1 ? group.gradient[(e * Dim + a) * pack_size + p % pack_size] : group.value_of(e, p % pack_size);
        weights[static_cast<std::size_t>(side)].push_back(std::move(at_node));
      }
    }
    for (std::size_t p = 0; p < weights[1].size(); ++p)
      for (std::size_t i = 0; i < weights[1][p].size(); ++i)
        EXPECT_NEAR((weights[2][p][i] - weights[0][p][i]) / (2 * step), weights[1][p][i], 1e-8);
  }
}

template <int Dim>
void a_point_out_of_reach_is_marked(const std::string& name) {
  Cloud<Dim> cloud(name, 0.5, 0.0);
  cloud.points.position[0][13] = cloud.grid.origin[0] - 0.1 * cloud.grid.cell[0];
  cloud.points.position[1][14] = std::numeric_limits<double>::quiet_NaN();
  cloud.evaluate();
  for (Index p = 0; p < cloud.points.size(); ++p) {
    EXPECT_EQ(cloud.stencils.group_of(p).lost[p % pack_size], p == 13 || p == 14) << "point " << p;
    if (p == 13 || p == 14) {
      EXPECT_EQ(cloud.sum(p, 0.0, [](double N, auto& dN, auto) { return std::abs(N) + dN.norm(); }), 0.0);
    }
  }
}

template <int Dim>
void patches_have_a_known_shape_and_no_node_twice(const std::string& name) {
  const Cloud<Dim> cloud(name, 0.5, 0.1);
  for (Index p = 0; p < cloud.points.size(); ++p) {
    const StencilGroup<Dim>& group = cloud.stencils.group_of(p);
    EXPECT_NE(std::ranges::find(patch_shapes, group.shape), patch_shapes.end());
    ASSERT_EQ(group.count % group.shape.entries(), 0);
    for (int first = 0; first < group.count; first += group.shape.entries()) {
      std::set<Index> nodes;
      for (int e = first; e < first + group.shape.entries(); ++e) nodes.insert(group.node_of(e, p % pack_size));
      EXPECT_EQ(static_cast<int>(nodes.size()), group.shape.entries()) << "point " << p;
    }
  }
}

template <int Dim>
void rows_and_margin_hold_the_support(const std::string& name) {
  const Cloud<Dim> cloud(name, 0.5, 0.1);
  for (Index p = 0; p < cloud.points.size(); ++p) {
    const StencilGroup<Dim>& group = cloud.stencils.group_of(p);
    EXPECT_LE(group.count, cloud.shape->max_nodes());
    for (int e = 0; e < group.count; ++e) {
      const Counts<Dim> node = cloud.grid.index(group.node_of(e, p % pack_size));
      EXPECT_GE(node[Dim - 1], group.lowest[p % pack_size]);
      EXPECT_LE(node[Dim - 1], group.highest[p % pack_size]);
      for (int a = 0; a < Dim; ++a) {
        const double away = (cloud.grid.position(node)[a] - cloud.points.position[a][p]) / cloud.grid.cell[a];
        EXPECT_LE(std::abs(away), cloud.shape->margin() + 2.0);
      }
    }
  }
}

template <int Dim>
void a_point_gets_the_same_bits_in_any_lane(const std::string& name) {
  const Cloud<Dim> all(name, 0.4, 0.2, 64);
  Cloud<Dim> shifted(name, 0.4, 0.2, 61);
  const auto copy = [&](auto member) {
    for (int c = 0; c < (all.points.*member).components(); ++c)
      std::copy_n((all.points.*member)[c] + 3, 61, (shifted.points.*member)[c]);
  };
  copy(&Points<Dim>::position);
  copy(&Points<Dim>::half_size);
  copy(&Points<Dim>::deformation_gradient);
  shifted.evaluate();
  const auto total = [](const Cloud<Dim>& cloud, Index p) {
    return cloud.sum(p, 0.0, [](double N, const Vec<Dim>& dN, const Vec<Dim>& x) { return N * x.sum() + dN.dot(x); });
  };
  for (Index p = 0; p < 61; ++p) EXPECT_NEAR(total(shifted, p), total(all, p + 3), 1e-14);
}

class EveryScheme : public testing::TestWithParam<std::string> {};

TEST_P(EveryScheme, HasWeightsThatSumToOneAndGradientsThatSumToZero) {
  for (const bool walls : {false, true}) {
    weights_sum_to_one<2>(GetParam(), walls);
    weights_sum_to_one<3>(GetParam(), walls);
  }
}
TEST_P(EveryScheme, ReproducesALinearFieldAndItsGradientInEveryCell) {
  for (const bool walls : {false, true}) {
    linear_fields_are_exact<2>(GetParam(), walls);
    linear_fields_are_exact<3>(GetParam(), walls);
  }
}
TEST_P(EveryScheme, HasGradientsThatMatchDifferenceQuotients) {
  if (!scheme<2>(GetParam())->gradients_follow_weights()) GTEST_SKIP() << "it says that they do not";
  gradients_match_difference_quotients<2>(GetParam());
  gradients_match_difference_quotients<3>(GetParam());
}
TEST_P(EveryScheme, MarksAPointWhoseSupportLeavesTheGrid) {
  a_point_out_of_reach_is_marked<2>(GetParam());
  a_point_out_of_reach_is_marked<3>(GetParam());
}
TEST_P(EveryScheme, TellsTheRowsAndTheMarginOfItsSupport) {
  rows_and_margin_hold_the_support<2>(GetParam());
  rows_and_margin_hold_the_support<3>(GetParam());
}
TEST_P(EveryScheme, GroupsNodesIntoPatchesThatTheTransfersKnow) {
  patches_have_a_known_shape_and_no_node_twice<2>(GetParam());
  patches_have_a_known_shape_and_no_node_twice<3>(GetParam());
}
TEST_P(EveryScheme, GivesAPointTheSameWeightsInAnyLane) {
  a_point_gets_the_same_bits_in_any_lane<2>(GetParam());
  a_point_gets_the_same_bits_in_any_lane<3>(GetParam());
}
TEST_P(EveryScheme, SpreadsPointsToAllSidesIfItSaysSo) {
  a_scheme_that_spreads_points_has_second_moments<2>(GetParam());
  a_scheme_that_spreads_points_has_second_moments<3>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryScheme, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
