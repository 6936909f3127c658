/// Sorting points by cell: everything that belongs to a point moves with it, and slabs hold the rows that they name.
#include "core/state/cell_order.hpp"

#include <gtest/gtest.h>
#include <random>
#include <set>

namespace riedel::test {
namespace {

template <int Dim>
std::vector<Columns*> columns_of(Points<Dim>& p) { // by hand, so that a field left out of Points::fields() is noticed
  return {&p.position,
          &p.velocity,
          &p.mass,
          &p.volume,
          &p.initial_volume,
          &p.half_size,
          &p.deformation_gradient,
          &p.velocity_gradient,
          &p.stress,
          &p.transfer_data,
          &p.state,
          &p.rate_norm,
          &p.averaged,
          &p.shear_strain,
          &p.work,
          &p.expansion};
}

/// Points anywhere on a grid; every other field identifies its point and component.
template <int Dim>
struct Shuffled {
  Grid<Dim> grid;
  Points<Dim> points;
  Slabs slabs;
  SortSpace space;

  explicit Shuffled(Index count) {
    grid.cell.setConstant(0.25);
    grid.cell[Dim - 1] = 0.1;
    grid.origin.setConstant(-1.0);
    grid.nodes.fill(9);
    grid.nodes[Dim - 1] = 24;
    points.transfer_data = Columns(2); // as a transfer may ask for them
    points.resize(count, 3);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::vector<Columns*> columns = columns_of(points);
    for (Index p = 0; p < count; ++p) {
      for (std::size_t f = 0; f < columns.size(); ++f)
        for (int c = 0; c < columns[f]->components(); ++c) (*columns[f])[c][p] = label(f, c, p);
      for (int a = 0; a < Dim; ++a)
        points.position[a][p] = grid.origin[a] + unit(random) * grid.cell[a] * (grid.nodes[a] - 1);
    }
  }
  static double label(std::size_t field, int component, Index id) {
    return 1e6 * static_cast<double>(field + 1) + 1e4 * component + id;
  }
  Index row_of(Index p) const {
    const int a = Dim - 1;
    return static_cast<Index>(std::floor((points.position[a][p] - grid.origin[a]) / grid.cell[a]));
  }
};

template <int Dim>
void sorting_moves_all_fields_together() {
  Shuffled<Dim> s(501);
  const Points<Dim> before = s.points;
  sort_by_cell(s.grid, 7, s.points, s.slabs, s.space);
  const std::vector<Columns*> columns = columns_of(s.points);
  ASSERT_NE(s.points.id, before.id) << "nothing was sorted";
  for (Index p = 0; p < s.points.size(); ++p) {
    const Index id = s.points.id[static_cast<std::size_t>(p)];
    EXPECT_EQ(s.points.position_of(p), before.position_of(id));
    for (std::size_t f = 1; f < columns.size(); ++f)
      for (int c = 0; c < columns[f]->components(); ++c)
        EXPECT_EQ((*columns[f])[c][p], s.label(f, c, id)) << "field " << f << ", component " << c;
  }
}

template <int Dim>
void place_is_the_inverse_of_id() {
  Shuffled<Dim> s(501);
  for (const Index rows : {3, 8}) { // sorted twice, as a run does
    sort_by_cell(s.grid, rows, s.points, s.slabs, s.space);
    std::vector<Index> ids = s.points.id;
    for (Index p = 0; p < s.points.size(); ++p)
      EXPECT_EQ(s.points.place[static_cast<std::size_t>(s.points.id[static_cast<std::size_t>(p)])], p);
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < ids.size(); ++i) ASSERT_EQ(ids[i], static_cast<Index>(i)) << "an id is lost";
  }
}

template <int Dim>
void slabs_hold_their_rows() {
  Shuffled<Dim> s(501);
  for (const Index rows : {1, 5, 24, 100}) {
    sort_by_cell(s.grid, rows, s.points, s.slabs, s.space);
    EXPECT_EQ(s.slabs.rows, rows);
    EXPECT_EQ(s.slabs.count(), (s.grid.nodes[Dim - 1] + rows - 1) / rows);
    Index next = 0;
    for (Index slab = 0; slab < s.slabs.count(); ++slab) {
      const Range range = s.slabs.range(slab);
      EXPECT_EQ(range.begin, next) << "slabs follow each other";
      for (Index p = range.begin; p < range.end; ++p) EXPECT_EQ(s.row_of(p) / rows, slab) << "point " << p;
      next = range.end;
    }
    EXPECT_EQ(next, s.points.size());
  }
}

TEST(CellOrder, MovesEveryFieldOfAPointTogether) {
  sorting_moves_all_fields_together<2>();
  sorting_moves_all_fields_together<3>();
}
TEST(CellOrder, KeepsTrackOfWhereEachPointStands) {
  place_is_the_inverse_of_id<2>();
  place_is_the_inverse_of_id<3>();
}
TEST(CellOrder, CutsThePointsIntoSlabsOfRows) {
  slabs_hold_their_rows<2>();
  slabs_hold_their_rows<3>();
}

TEST(CellOrder, PutsPointsOfOneCellNextToEachOtherAndKeepsTheirOrder) {
  Shuffled<2> s(801);
  sort_by_cell(s.grid, 8, s.points, s.slabs, s.space);
  std::set<std::pair<Index, Index>> left;
  std::pair<Index, Index> cell{-1, -1};
  for (Index p = 0; p < s.points.size(); ++p) {
    const auto column = static_cast<Index>(std::floor((s.points.position[0][p] - s.grid.origin[0]) / s.grid.cell[0]));
    const std::pair<Index, Index> here{column, s.row_of(p)};
    if (here == cell) {
      EXPECT_GT(s.points.id[static_cast<std::size_t>(p)], s.points.id[static_cast<std::size_t>(p - 1)]);
    } else {
      EXPECT_TRUE(left.insert(here).second) << "the cell was met before";
    }
    cell = here;
  }
}

TEST(CellOrder, ChangesNothingWhenPointsAreSortedAlready) {
  Shuffled<3> s(300);
  sort_by_cell(s.grid, 6, s.points, s.slabs, s.space);
  const std::vector<Index> ids = s.points.id;
  sort_by_cell(s.grid, 6, s.points, s.slabs, s.space);
  EXPECT_EQ(s.points.id, ids);
}

TEST(CellOrder, CountsPointsThatStandBehindALaterCell) {
  Shuffled<2> s(600);
  EXPECT_GT(out_of_order(s.grid, s.points, s.space), 200) << "points thrown anywhere";
  sort_by_cell(s.grid, 8, s.points, s.slabs, s.space);
  EXPECT_EQ(out_of_order(s.grid, s.points, s.space), 0);
  s.points.position[1][300] = s.grid.origin[1]; // one point falls into the first row
  EXPECT_EQ(out_of_order(s.grid, s.points, s.space), 1);
}

TEST(CellOrder, LetsSlabsOfOneParityTouchNoCommonRow) {
  Slabs slabs{.rows = 8, .begin = {}};
  for (Index s = 0; s < 5; ++s) {
    EXPECT_EQ(slabs.node_rows(s).end, slabs.node_rows(s + 2).begin) << "all rows are somebody's";
    EXPECT_LT(slabs.node_rows(s).begin, s * 8) << "room for a support that reaches down";
    EXPECT_GT(slabs.node_rows(s).end, (s + 1) * 8 + 1) << "and up, beyond the upper nodes of the last row";
  }
}

TEST(CellOrder, LosesNoPointThatLiesOffTheGridOrNowhere) {
  Shuffled<2> s(40);
  s.points.position[0][3] = 1e9;
  s.points.position[1][7] = -1e9;
  s.points.position[1][11] = std::numeric_limits<double>::quiet_NaN();
  sort_by_cell(s.grid, 6, s.points, s.slabs, s.space);
  EXPECT_EQ(s.slabs.begin.back(), 40);
  EXPECT_EQ(s.points.position[0][s.points.place[3]], 1e9);
}

} // namespace
} // namespace riedel::test
