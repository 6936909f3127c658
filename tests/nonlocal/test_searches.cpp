/// The contract of NeighbourSearch, over the registry: a search is tested by being registered.
#include "nonlocal/clouds.hpp"

#include "nonlocal/register.hpp"
#include "nonlocal/rows.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace riedel {
namespace {

template <class Dimension>
class EverySearch : public testing::Test {
protected:
  static constexpr int axes = Dimension::value;

  EverySearch() { register_nonlocal<axes>(catalogue_); }

  /// Calls `check(search)` for every registered search.
  void for_every_search(const auto& check) {
    for (const auto& entry : catalogue_.searches.entries()) {
      SCOPED_TRACE(entry.description.name);
      check(*entry.make());
    }
  }
  static NeighbourRows brute_force(const Columns& x, double radius) {
    NeighbourRows rows{{0}, {}};
    for (Index p = 0; p < x.size(); ++p) {
      const std::size_t first = rows.index.size();
      for (Index q = 0; q < x.size(); ++q) rows.index.push_back(q);
      // The library's rounding: in a portable build it may have been compiled for another processor than this program.
      keep_neighbours<axes>(x, p, radius, first, rows.index);
      rows.start.push_back(static_cast<std::int64_t>(rows.index.size()));
    }
    return rows;
  }
  static void expect_same(const NeighbourRows& a, const NeighbourRows& b) {
    EXPECT_EQ(a.start, b.start);
    EXPECT_EQ(a.index, b.index);
  }

  CatalogueOf<axes> catalogue_;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EverySearch, Dimensions, );

TYPED_TEST(EverySearch, FindsTheRowsOfBruteForceInEveryCloud) {
  this->for_every_search([&](auto& search) {
    NeighbourRows rows;
    for (const Cloud& cloud : clouds<TestFixture::axes>())
      for (const double radius : {1e-9, 0.03, 0.125, 0.15, 0.3125, 5.0}) {
        SCOPED_TRACE(cloud.name + ", radius " + std::to_string(radius));
        search.find(cloud.positions, radius, rows);
        this->expect_same(rows, this->brute_force(cloud.positions, radius));
      }
  });
}

TYPED_TEST(EverySearch, CountsAPointExactlyOnTheRadiusAsANeighbour) {
  constexpr int dim = TestFixture::axes;
  const Columns x = lattice<dim>(cube<dim>(5), 0.25); // the point in the middle, radius two spacings
  const Index middle = (x.size() - 1) / 2;
  this->for_every_search([&](auto& search) {
    NeighbourRows rows;
    search.find(x, 0.5, rows);
    EXPECT_EQ(rows.start[middle + 1] - rows.start[middle], dim == 2 ? 13 : 33);
    search.find(x, std::nextafter(0.5, 0.0), rows);
    EXPECT_EQ(rows.start[middle + 1] - rows.start[middle], dim == 2 ? 9 : 27);
  });
}

TYPED_TEST(EverySearch, FindsCoincidentPointsWithARadiusOfZero) {
  Columns x = random_points<TestFixture::axes>(50, 1.0);
  for (int a = 0; a < TestFixture::axes; ++a) x[a][40] = x[a][3];
  this->for_every_search([&](auto& search) {
    NeighbourRows rows;
    search.find(x, 0.0, rows);
    this->expect_same(rows, this->brute_force(x, 0.0));
    EXPECT_EQ(rows.index.size(), 52U);
  });
}

TYPED_TEST(EverySearch, FindsTheSameRowsFarFromTheOrigin) {
  Columns x = random_points<TestFixture::axes>(400, 1.0);
  for (Index p = 0; p < x.size(); ++p) x[0][p] += 1e7;
  this->for_every_search([&](auto& search) {
    NeighbourRows rows;
    search.find(x, 0.125, rows);
    this->expect_same(rows, this->brute_force(x, 0.125));
  });
}

TYPED_TEST(EverySearch, AgreesWithTheOthersOnWhatLiesOnTheRadiusToRounding) {
  constexpr int dim = TestFixture::axes;
  const double h = 5e-3 / 3;
  const Columns x = lattice<dim>(cube<dim>(dim == 2 ? 40 : 12), h);
  for (const double radius : {h, std::sqrt(2.0) * h, 2 * h, std::sqrt(5.0) * h, 3 * h, 5 * h}) {
    NeighbourRows first, rows;
    this->catalogue_.searches.entries().front().make()->find(x, radius, first);
    this->for_every_search([&](auto& search) {
      search.find(x, radius, rows);
      this->expect_same(rows, first);
    });
  }
}

TYPED_TEST(EverySearch, FindsTheSameRowsWithAnyNumberOfThreads) {
  const Columns x = random_points<TestFixture::axes>(3000, 1.0);
  const int before = omp_get_max_threads();
  this->for_every_search([&](auto& search) {
    NeighbourRows one, more;
    omp_set_num_threads(1);
    search.find(x, 0.07, one);
    for (const int threads : {2, 3, 4}) {
      omp_set_num_threads(threads);
      search.find(x, 0.07, more);
      this->expect_same(more, one);
    }
  });
  omp_set_num_threads(before);
}

TYPED_TEST(EverySearch, NamesThePointWhosePositionIsNotANumber) {
  Columns x = random_points<TestFixture::axes>(20, 1.0);
  x[1][13] = std::nan("");
  this->for_every_search([&](auto& search) {
    NeighbourRows rows;
    try {
      search.find(x, 0.1, rows);
      ADD_FAILURE() << "not noticed";
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("point 13"), std::string::npos) << error.what();
    }
  });
}

} // namespace
} // namespace riedel
