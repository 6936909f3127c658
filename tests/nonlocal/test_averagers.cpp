/// The contract of NonlocalAverager, over the registry with every search.
#include "nonlocal/averages.hpp"

#include "nonlocal/register.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <omp.h>

namespace riedel {
namespace {

template <class Dimension>
class EveryAverager : public testing::Test {
protected:
  static constexpr int axes = Dimension::value;
  static constexpr Index count = axes == 2 ? 900 : 1500;

  EveryAverager() { register_nonlocal<axes>(catalogue_); }

  /// Calls `check(make, tolerance)` for every averager with every search; `make()` gives a new one of length l_c.
  void for_every_averager(const auto& check) {
    for (const auto& averager : catalogue_.averagers.entries())
      for (const auto& search : catalogue_.searches.entries()) {
        SCOPED_TRACE(averager.description.name + " with " + search.description.name);
        const auto make = [&] { return averager.make(length_, search.make()); };
        check(make, make()->tolerance());
      }
  }

  CatalogueOf<axes> catalogue_;
  double length_ = 0.06; ///< l_c; the clouds fill a box of edge 1
  Columns x_ = random_points<axes>(count, 1.0);
  Numbers volumes_ = random_numbers(count, 0.5, 1.5, 7);
  Numbers field_ = random_numbers(count, 0.0, 1.0, 8);
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EveryAverager, Dimensions, );

TYPED_TEST(EveryAverager, LeavesAUniformFieldAsItIsAlsoAtTheEdges) {
  this->for_every_averager([&](const auto& make, double) {
    const Numbers uniform(this->field_.size(), 3.7);
    expect_near(averaged(*make(), this->x_, this->volumes_, uniform), uniform, 1e-14);
  });
}

TYPED_TEST(EveryAverager, GivesTheDenseSumOverAllPairs) {
  const Numbers expected = dense_sum<TestFixture::axes>(this->x_, this->volumes_, this->field_, this->length_);
  this->for_every_averager([&](const auto& make, double tolerance) {
    expect_near(averaged(*make(), this->x_, this->volumes_, this->field_), expected, tolerance);
  });
}

TYPED_TEST(EveryAverager, CountsAPointOfDoubleVolumeTwice) {
  const Index n = this->x_.size();
  Columns twice(TestFixture::axes); // one more point, at the position of point 5, with its volume and field
  twice.resize(n + 1);
  for (int a = 0; a < TestFixture::axes; ++a) {
    std::copy_n(this->x_[a], n, twice[a]);
    twice[a][n] = this->x_[a][5];
  }
  Numbers doubled = this->volumes_, volumes = this->volumes_, field = this->field_;
  doubled[5] *= 2;
  volumes.push_back(volumes[5]);
  field.push_back(field[5]);
  this->for_every_averager([&](const auto& make, double) {
    Numbers of_twice = averaged(*make(), twice, volumes, field);
    of_twice.pop_back();
    expect_near(averaged(*make(), this->x_, doubled, this->field_), of_twice, 1e-14);
  });
}

TYPED_TEST(EveryAverager, PermutesItsResultWithThePoints) {
  std::vector<Index> order(this->field_.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Columns x = this->x_;
  AlignedVector<double> scratch;
  x.reorder(order, scratch);
  const auto permuted = [&](const Numbers& a) {
    Numbers b(a.size());
    for (std::size_t p = 0; p < a.size(); ++p) b[p] = a[order[p]];
    return b;
  };
  this->for_every_averager([&](const auto& make, double) {
    const auto averager = make();
    const Numbers before = averaged(*averager, this->x_, this->volumes_, this->field_);
    averager->invalidate();
    expect_near(averaged(*averager, x, permuted(this->volumes_), permuted(this->field_)), permuted(before), 1e-13);
    EXPECT_EQ(averager->searches(), 2);
  });
}

TYPED_TEST(EveryAverager, GivesTheSameBitsForAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  this->for_every_averager([&](const auto& make, double) {
    omp_set_num_threads(1);
    const Numbers one = averaged(*make(), this->x_, this->volumes_, this->field_);
    for (const int threads : {2, 4}) {
      omp_set_num_threads(threads);
      EXPECT_EQ(averaged(*make(), this->x_, this->volumes_, this->field_), one) << threads << " threads";
    }
  });
  omp_set_num_threads(before);
}

TYPED_TEST(EveryAverager, GivesTheSameBitsWithEverySearch) {
  for (const auto& averager : this->catalogue_.averagers.entries()) {
    std::vector<Numbers> results;
    for (const auto& search : this->catalogue_.searches.entries())
      results.push_back(averaged(*averager.make(this->length_, search.make()), this->x_, this->volumes_, this->field_));
    for (const Numbers& result : results) EXPECT_EQ(result, results.front());
  }
}

TYPED_TEST(EveryAverager, NoticesThatThereAreOtherPoints) {
  const Columns fewer = random_points<TestFixture::axes>(100, 0.4);
  const Numbers volumes(100, 1.0), field = random_numbers(100, 0.0, 1.0, 9);
  this->for_every_averager([&](const auto& make, double tolerance) {
    const auto averager = make();
    averaged(*averager, this->x_, this->volumes_, this->field_);
    expect_near(averaged(*averager, fewer, volumes, field),
                dense_sum<TestFixture::axes>(fewer, volumes, field, this->length_), tolerance);
  });
}

TYPED_TEST(EveryAverager, GivesTheSameToRoundingWithKeptNeighboursAsWithFreshOnes) {
  this->for_every_averager([&](const auto& make, double) {
    const auto kept = make();
    Columns x = this->x_;
    int calls = 0;
    for (; calls < 40; ++calls) {
      shake<TestFixture::axes>(x, 0.01 * this->length_, 100 + calls); // far enough for new weights at each call
      expect_near(averaged(*kept, x, this->volumes_, this->field_), averaged(*make(), x, this->volumes_, this->field_),
                  1e-14); // the same weights, summed in another order
    }
    EXPECT_LT(kept->searches(), calls / 2);
  });
}

TYPED_TEST(EveryAverager, SearchesOnceWhileNothingMovesUnlessToldToForget) {
  this->for_every_averager([&](const auto& make, double) {
    const auto averager = make();
    for (int call = 0; call < 5; ++call) averaged(*averager, this->x_, this->volumes_, this->field_);
    EXPECT_EQ(averager->searches(), 1);
    averager->invalidate();
    averaged(*averager, this->x_, this->volumes_, this->field_);
    EXPECT_EQ(averager->searches(), 2);
  });
}

} // namespace
} // namespace riedel
