/// Grids, bodies and walls from positions in metres.
#include "core/setup/fill.hpp"
#include "core/setup/walls.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Setup, PutsLinesOfTheGridThroughTheCornersOfABox) {
  const Grid<2> grid = grid_around<2>({0.1, -0.2}, {0.5, 0.4}, 0.1, 3);
  EXPECT_EQ(grid.nodes, (Counts<2>{4 + 6 + 1, 6 + 6 + 1}));
  EXPECT_TRUE(grid.position({3, 3}).isApprox(Vec<2>(0.1, -0.2)));
  EXPECT_TRUE(grid.position({7, 9}).isApprox(Vec<2>(0.5, 0.4)));
}

TEST(Setup, RefusesABoxWithoutWholeCells) {
  EXPECT_THAT(
      [] {
        (void)grid_around<2>({0.0, 0.0}, {1.0, 0.25}, 0.1, 2);
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("along axis 1"), HasSubstr("2.5 cells"))));
  EXPECT_THROW((void)grid_around<2>({0.0, 0.0}, {1.0, 1.0}, 0.0, 2), InputError);
  EXPECT_THROW((void)grid_around<3>({0.0, 0.0, 0.0}, {1.0, 1.0, -1.0}, 0.1, 2), InputError);
}

template <int Dim>
void expect_a_ball(const Vec<Dim>& upper, double volume) {
  const Grid<Dim> grid = grid_around<Dim>(Vec<Dim>::Zero(), upper, 0.05, 2);
  const Vec<Dim> centre = 0.5 * upper;
  const Body<Dim> body = make_body<Dim>("ball", material("linear_elastic"), grid, 2,
                                        [&](const Vec<Dim>& x) { return (x - centre).norm() < 0.4; });
  double all = 0.0;
  for (Index p = 0; p < body.points.size(); ++p) {
    EXPECT_LT((body.points.position_of(p) - centre).norm(), 0.4);
    EXPECT_DOUBLE_EQ(body.points.mass[0][p], body.material->density({}) * body.points.volume[0][p]);
    EXPECT_EQ(body.points.volume[0][p], body.points.initial_volume[0][p]);
    for (int a = 0; a < Dim; ++a) EXPECT_DOUBLE_EQ(body.points.half_size[a][p], 0.0125);
    all += body.points.volume[0][p];
  }
  EXPECT_NEAR(all, volume, 0.01 * volume);
}

TEST(Setup, PutsPointsWhereAShapeSaysAndGivesThemTheirMass) {
  expect_a_ball<2>({1.0, 1.0}, std::numbers::pi * 0.16);
  expect_a_ball<3>({1.0, 1.0, 1.0}, 4.0 / 3.0 * std::numbers::pi * 0.064);
}

TEST(Setup, GivesEveryPointTheStateThatIsAskedForOrTheLawsOwn) {
  const Grid<2> grid = grid_around<2>({0.0, 0.0}, {0.2, 0.2}, 0.1, 2);
  const auto sand = material("gudehus_bauer");
  const auto everywhere = [](const Vec<2>& x) { return x.minCoeff() > 0.0 && x.maxCoeff() < 0.2; };
  const int e = state_column(sand->states(), "void_ratio");
  EXPECT_EQ(make_body<2>("sand", sand, grid, 1, everywhere).points.state[e][3], sand->initial_state()[std::size_t(e)]);
  std::vector<double> state = sand->initial_state();
  state[static_cast<std::size_t>(e)] = 0.61;
  const Body<2> body = make_body<2>("sand", sand, grid, 1, everywhere, state);
  EXPECT_EQ(body.points.size(), 4);
  EXPECT_EQ(body.points.state[e][3], 0.61);
  EXPECT_DOUBLE_EQ(body.points.mass[0][0], sand->density(state) * 0.01);
  EXPECT_THAT(
      [&] {
        (void)make_body<2>("sand", sand, grid, 1, everywhere, {0.6, 0.0, 0.0, 0.0, 0.0});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("body 'sand'"), HasSubstr("its law declares "))));
  EXPECT_THAT([&] { (void)make_body<2>("sand", sand, grid, 1, [](const Vec<2>&) { return false; }); },
              ThrowsMessage<InputError>(HasSubstr("its shape contains no point of the grid")));
}

TEST(Setup, HoldsEverythingBehindAWall) {
  const Grid<2> grid = grid_around<2>({0.0, 0.0}, {1.0, 1.0}, 0.25, 2);
  const auto bound = [&](const Boundary<2>& wall) -> const BoundaryCondition<2>& {
    wall->bind(grid, *scheme<2>("linear"));
    return *wall;
  };
  const auto given = [](const Boundary<2>& wall) { return dynamic_cast<PrescribedVelocity<2>&>(*wall).given(); };
  const Boundary<2> floor = smooth_wall(grid, "floor", 1, 0.0, Behind::lower);
  EXPECT_EQ(given(floor).axis, 1);
  EXPECT_EQ(bound(floor).nodes().size(), 9U * 3U);
  EXPECT_EQ(given(floor).velocity(1.0), 0.0);
  const Boundary<2> right = smooth_wall(grid, "right", 0, 1.0, Behind::upper);
  EXPECT_EQ(bound(right).nodes().size(), 9U * 3U);
  EXPECT_EQ(grid.position(grid.index(right->nodes().front()))[0], 1.0);
  const std::vector<Boundary<2>> rough = rough_wall(grid, "floor", 1, 0.0, Behind::lower);
  ASSERT_EQ(rough.size(), 2U);
  EXPECT_EQ(rough[0]->name(), "floor_x");
  EXPECT_EQ(given(rough[0]).axis, 0);
  EXPECT_EQ(given(rough[1]).axis, 1);
  EXPECT_EQ(bound(rough[0]).nodes(), bound(rough[1]).nodes());
}

TEST(Setup, RefusesAWallBetweenTheLinesOfTheGridAndNamesThem) {
  const Grid<2> grid = grid_around<2>({0.0, 0.0}, {1.0, 1.0}, 0.25, 2);
  EXPECT_THAT([&] { (void)smooth_wall(grid, "floor", 1, 0.3, Behind::lower); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("wall 'floor' at 0.3 m along axis 1"),
                                              HasSubstr("beside it are at 0.25 m and 0.5 m"))));
  EXPECT_THROW((void)smooth_wall(grid, "floor", 1, 9.0, Behind::lower), InputError);
}

} // namespace
} // namespace riedel::test
