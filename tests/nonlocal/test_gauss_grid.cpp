/// Properties of `gauss_grid` alone: its error against the sum over pairs, and the size of its grid.
#include "nonlocal/averages.hpp"

#include "nonlocal/cell_list.hpp"
#include "nonlocal/gauss.hpp"
#include "nonlocal/gauss_grid.hpp"

namespace riedel {
namespace {

constexpr double length = 1.5e-3; ///< l_c [m]

/// d peaked in a band through the middle, at 57° in the plane of the first two axes: 1/cosh²(s/w), 1.76 w thick at
/// half its height. @param thickness 1.76 w, in l_c [-]
Numbers band(const Columns& x, double thickness) {
  Vec<2> middle;
  for (int a = 0; a < 2; ++a) {
    const auto [lower, upper] = std::minmax_element(x[a], x[a] + x.size());
    middle[a] = 0.5 * (*lower + *upper);
  }
  const double angle = 57.0 * 3.14159265358979 / 180.0, w = thickness * length / 1.76;
  Numbers d(static_cast<std::size_t>(x.size()));
  for (Index p = 0; p < x.size(); ++p) {
    const double s = (x[0][p] - middle[0]) * std::sin(angle) - (x[1][p] - middle[1]) * std::cos(angle);
    d[p] = 1.0 / square(std::cosh(s / w));
  }
  return d;
}

template <int Dim>
Columns disturbed(const Counts<Dim>& counts, double spacing, double part) {
  Columns x = lattice<Dim>(counts, spacing);
  shake<Dim>(x, part * spacing, 11);
  return x;
}

/// Largest difference from the sum over pairs, anywhere in the specimen, edges included.
template <int Dim>
double error(const Columns& x, double thickness, double spacing) {
  const Numbers volumes(static_cast<std::size_t>(x.size()), 1.0), d = band(x, thickness);
  GaussAverager<Dim> pairs(length, std::make_unique<CellList<Dim>>());
  GaussGridAverager<Dim> grid(length, spacing);
  return largest_difference(averaged(grid, x, volumes, d), averaged(pairs, x, volumes, d));
}

/// The largest error over the specimens of 24 × 84 and 32 × 112 cells, one or four points in each, as they are and
/// disturbed.
double largest_error(double thickness, double spacing) {
  double largest = 0.0;
  for (const double part : {0.0, 0.1, 0.3}) {
    largest = std::max(largest, error<2>(disturbed<2>({24, 84}, 5e-3 / 3, part), thickness, spacing));
    largest = std::max(largest, error<2>(disturbed<2>({32, 112}, 1.25e-3, part), thickness, spacing));
    largest = std::max(largest, error<2>(disturbed<2>({64, 224}, 0.625e-3, part), thickness, spacing));
  }
  return largest;
}

TEST(GaussGridAverager, HasTheDocumentedErrorForEachSpacing) {
  struct Row {
    double spacing, thick, thin; ///< errors in bands 5 and 2.7 l_c thick
  };
  for (const Row& row : {Row{0.25, 1.2e-4, 2.0e-4}, Row{0.33, 4.0e-4, 6.3e-4}, Row{0.4, 5.5e-4, 8.3e-4},
                         Row{0.5, 1.25e-3, 2.1e-3}, Row{0.6, 2.1e-3, 3.5e-3}}) {
    SCOPED_TRACE("spacing of " + std::to_string(row.spacing) + " l_c");
    EXPECT_NEAR(largest_error(5.0, row.spacing), row.thick, 0.1 * row.thick);
    EXPECT_NEAR(largest_error(2.7, row.spacing), row.thin, 0.1 * row.thin);
  }
}

TEST(GaussGridAverager, IsWithinAThousandthOfTheSumOverPairsInSpace) {
  constexpr double spacing = GaussGridAverager<3>::default_spacing;
  EXPECT_LT(error<3>(disturbed<3>({15, 15, 15}, length / 1.2, 0.1), 2.7, spacing), 1e-3);
  EXPECT_LT(error<3>(disturbed<3>({20, 20, 20}, length / 2.4, 0.3), 2.7, spacing), 1e-3);
}

/// A grid around points at another position has its node 0 and its strips at another position.
TEST(GaussGridAverager, GivesTheSameBitsWhereverTheGridWasLaidOut) {
  Columns x = random_points<2>(500, 20 * length), more = random_points<2>(500, 60 * length, 2);
  for (int a = 0; a < 2; ++a) std::copy_n(x[a], 400, more[a]);
  const Numbers volumes = random_numbers(500, 0.5, 1.5, 7), field = random_numbers(500, 0.0, 1.0, 8);
  GaussGridAverager<2> kept(length), fresh(length);
  averaged(kept, more, volumes, field);
  EXPECT_EQ(averaged(kept, x, volumes, field), averaged(fresh, x, volumes, field));
  EXPECT_EQ(kept.searches(), 1);
}

TEST(GaussGridAverager, LaysOutItsGridAnewWhenAPointHasLeftIt) {
  Columns x = random_points<2>(500, 20 * length);
  const Numbers volumes(500, 1.0), field = random_numbers(500, 0.0, 1.0, 8);
  GaussGridAverager<2> averager(length);
  averaged(averager, x, volumes, field);
  x[1][17] -= 30 * length;
  expect_near(averaged(averager, x, volumes, field), dense_sum<2>(x, volumes, field, length), 5e-3);
  EXPECT_EQ(averager.searches(), 2);
}

TEST(GaussGridAverager, RefusesAGridForAPointFarAwayAndNamesIt) {
  for (const double far : {100.0, 1e12, 1e300}) {
    Columns x = random_points<3>(500, 20 * length);
    x[1][17] = -far;
    GaussGridAverager<3> averager(length);
    try {
      averager.update_neighbours(x);
      ADD_FAILURE() << "not noticed";
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("point 17 at ("), std::string::npos) << error.what();
    }
  }
}

TEST(GaussGridAverager, NamesThePointWhosePositionIsNotANumber) {
  Columns x = random_points<2>(50, 20 * length);
  GaussGridAverager<2> averager(length);
  averager.update_neighbours(x);
  x[1][13] = std::nan("");
  try {
    averager.update_neighbours(x);
    ADD_FAILURE() << "not noticed";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("point 13"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace riedel
