/// The contract of NonlocalAverager, over the registry with every search, and what is particular to `gauss`.
#include "nonlocal/clouds.hpp"

#include "nonlocal/gauss.hpp"
#include "nonlocal/register.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <omp.h>

namespace riedel {
namespace {

using Numbers = std::vector<double>;

Numbers random_numbers(Index count, double lower, double upper, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(lower, upper);
  Numbers answer(static_cast<std::size_t>(count));
  for (double& x : answer) x = number(random);
  return answer;
}

template <int Dim>
Numbers averaged(NonlocalAverager<Dim>& averager, const Columns& x, const Numbers& volumes, const Numbers& field) {
  Numbers answer(field.size());
  averager.follow(x);
  averager.average(volumes.data(), field.data(), answer.data());
  return answer;
}

/// The sum over all pairs as it stands in the paper, with the cut, written without the library's weight.
template <int Dim>
Numbers dense_sum(const Columns& x, const Numbers& volumes, const Numbers& field, double length) {
  Numbers answer(field.size());
  for (Index p = 0; p < x.size(); ++p) {
    double above = 0.0, below = 0.0;
    for (Index q = 0; q < x.size(); ++q) {
      const double r = std::sqrt(squared_distance<Dim>(x, p, q));
      if (r > 3 * length) continue;
      above += std::exp(-(r / length) * (r / length)) * volumes[q] * field[q];
      below += std::exp(-(r / length) * (r / length)) * volumes[q];
    }
    answer[p] = above / below;
  }
  return answer;
}

/// Weights are floats: bound of what that does to the average of a field that varies by one.
constexpr double rounding_of_weights = 2e-7;

void expect_near(const Numbers& a, const Numbers& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t p = 0; p < a.size(); ++p) ASSERT_NEAR(a[p], b[p], tolerance) << "at point " << p;
}

template <class Dimension>
class EveryAverager : public testing::Test {
protected:
  static constexpr int axes = Dimension::value;
  static constexpr Index count = axes == 2 ? 900 : 1500;

  EveryAverager() { register_nonlocal<axes>(catalogue_); }

  /// Calls `check(make)` for every averager with every search; `make()` gives a fresh one of length l_c.
  void for_every_averager(const auto& check) {
    for (const auto& averager : catalogue_.averagers.entries())
      for (const auto& search : catalogue_.searches.entries()) {
        SCOPED_TRACE(averager.description.name + " with " + search.description.name);
        check([&] { return averager.make(length_, search.make()); });
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
  this->for_every_averager([&](const auto& make) {
    const Numbers uniform(this->field_.size(), 3.7);
    expect_near(averaged(*make(), this->x_, this->volumes_, uniform), uniform, 1e-14);
  });
}

TYPED_TEST(EveryAverager, GivesTheDenseSumOverAllPairs) {
  const Numbers expected = dense_sum<TestFixture::axes>(this->x_, this->volumes_, this->field_, this->length_);
  this->for_every_averager([&](const auto& make) {
    expect_near(averaged(*make(), this->x_, this->volumes_, this->field_), expected, rounding_of_weights);
  });
}

TYPED_TEST(EveryAverager, CountsAPointOfDoubleVolumeTwice) {
  const Index n = this->x_.size();
  Columns twice(TestFixture::axes); // one more point, at the place of point 5, with its volume and field
  twice.resize(n + 1);
  for (int a = 0; a < TestFixture::axes; ++a) {
    std::copy_n(this->x_[a], n, twice[a]);
    twice[a][n] = this->x_[a][5];
  }
  Numbers doubled = this->volumes_, volumes = this->volumes_, field = this->field_;
  doubled[5] *= 2;
  volumes.push_back(volumes[5]);
  field.push_back(field[5]);
  this->for_every_averager([&](const auto& make) {
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
  this->for_every_averager([&](const auto& make) {
    const auto averager = make();
    const Numbers before = averaged(*averager, this->x_, this->volumes_, this->field_);
    averager->forget_neighbours();
    expect_near(averaged(*averager, x, permuted(this->volumes_), permuted(this->field_)), permuted(before), 1e-13);
    EXPECT_EQ(averager->searches(), 2);
  });
}

TYPED_TEST(EveryAverager, GivesTheSameBitsForAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  this->for_every_averager([&](const auto& make) {
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
  this->for_every_averager([&](const auto& make) {
    const auto averager = make();
    averaged(*averager, this->x_, this->volumes_, this->field_);
    expect_near(averaged(*averager, fewer, volumes, field),
                dense_sum<TestFixture::axes>(fewer, volumes, field, this->length_), rounding_of_weights);
  });
}

/// Moves every point its own way, at most by `step` along each axis.
template <int Dim>
void shake(Columns& x, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> way(-step, step);
  for (int a = 0; a < Dim; ++a)
    for (Index p = 0; p < x.size(); ++p) x[a][p] += way(random);
}

TYPED_TEST(EveryAverager, GivesTheSameToRoundingWithKeptNeighboursAsWithFreshOnes) {
  this->for_every_averager([&](const auto& make) {
    const auto kept = make();
    Columns x = this->x_;
    int calls = 0;
    for (; calls < 40; ++calls) {
      shake<TestFixture::axes>(x, 0.01 * this->length_, 100 + calls); // far enough for new weights at each call
      expect_near(averaged(*kept, x, this->volumes_, this->field_), averaged(*make(), x, this->volumes_, this->field_),
                  1e-14); // the same weights, summed in another order
    }
    EXPECT_GT(kept->searches(), 1);
    EXPECT_LT(kept->searches(), calls / 2);
  });
}

TYPED_TEST(EveryAverager, StaysWithinItsBoundOfTheDenseSumWhilePointsCreep) {
  constexpr double bound = 5.0 * GaussAverager<TestFixture::axes>::weights_last; // the field varies by one
  this->for_every_averager([&](const auto& make) {
    const auto averager = make();
    Columns x = this->x_;
    for (int call = 0; call < 12; ++call) {
      expect_near(averaged(*averager, x, this->volumes_, this->field_),
                  dense_sum<TestFixture::axes>(x, this->volumes_, this->field_, this->length_), bound);
      shake<TestFixture::axes>(x, 3e-4 * this->length_, 200 + call);
    }
    EXPECT_EQ(averager->searches(), 1);
  });
}

TYPED_TEST(EveryAverager, SearchesOnceWhileNothingMovesUnlessToldToForget) {
  this->for_every_averager([&](const auto& make) {
    const auto averager = make();
    for (int call = 0; call < 5; ++call) averaged(*averager, this->x_, this->volumes_, this->field_);
    EXPECT_EQ(averager->searches(), 1);
    averager->forget_neighbours();
    averaged(*averager, this->x_, this->volumes_, this->field_);
    EXPECT_EQ(averager->searches(), 2);
  });
}

/// The sum over a lattice acts like a smooth average over l = √(second moment of its weights), since ∫ x² ω = l_c²/2 ∫
/// ω for Gauss's weight: averaging x² in the middle of a wide lattice adds l²/2.
double acting_length(double spacing, double length) {
  const Columns x = lattice<2>({41, 41}, spacing);
  const Index middle = (x.size() - 1) / 2;
  Numbers squares(static_cast<std::size_t>(x.size()));
  for (Index p = 0; p < x.size(); ++p) squares[p] = square(x[0][p] - x[0][middle]);
  CatalogueOf<2> catalogue;
  register_nonlocal(catalogue);
  const auto averager = catalogue.averagers.find("gauss").make(length, catalogue.searches.find("cell_list").make());
  return std::sqrt(2 * averaged(*averager, x, Numbers(squares.size(), 1.0), squares)[middle]);
}

TEST(GaussAverager, ActsLikeAShorterLengthOnACoarseLattice) {
  const double length = 1.5e-3;
  EXPECT_NEAR(acting_length(2.5e-3, length) / length, 0.784, 5e-4);
  EXPECT_NEAR(acting_length(5e-3 / 3, length) / length, 0.994, 5e-4);
  EXPECT_NEAR(acting_length(1.25e-3, length) / length, 0.999, 5e-4);
}

} // namespace
} // namespace riedel
