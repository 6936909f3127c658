/// Properties of `gauss` alone: what it keeps from call to call, and its effect on a coarse lattice.
#include "nonlocal/averages.hpp"

#include "nonlocal/cell_list.hpp"
#include "nonlocal/gauss.hpp"

namespace riedel {
namespace {

template <int Dim>
GaussAverager<Dim> make_gauss(double length) {
  return GaussAverager<Dim>(length, std::make_unique<CellList<Dim>>());
}

template <class Dimension>
class GaussAveragers : public testing::Test {
protected:
  static constexpr int axes = Dimension::value;
  static constexpr Index count = axes == 2 ? 900 : 1500;

  double length_ = 0.06; ///< l_c; the points fill a box of edge 1
  Columns x_ = random_points<axes>(count, 1.0);
  Numbers volumes_ = random_numbers(count, 0.5, 1.5, 7);
  Numbers field_ = random_numbers(count, 0.0, 1.0, 8);
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(GaussAveragers, Dimensions, );

TYPED_TEST(GaussAveragers, StayWithinTheirBoundOfTheDenseSumWhilePointsCreep) {
  constexpr int dim = TestFixture::axes;
  constexpr double bound = 5.0 * GaussAverager<dim>::weights_last; // the field varies by one
  auto averager = make_gauss<dim>(this->length_);
  for (int call = 0; call < 12; ++call) {
    expect_near(averaged(averager, this->x_, this->volumes_, this->field_),
                dense_sum<dim>(this->x_, this->volumes_, this->field_, this->length_), bound);
    shake<dim>(this->x_, 3e-4 * this->length_, 200 + call);
  }
  EXPECT_EQ(averager.searches(), 1);
}

TYPED_TEST(GaussAveragers, SearchAnewBeforeANeighbourIsMissing) {
  constexpr int dim = TestFixture::axes;
  auto kept = make_gauss<dim>(this->length_);
  constexpr int calls = 60;
  for (int call = 0; call < calls; ++call) {
    // Every other point moves, by half of l_c in all and far enough for new weights at each call.
    for (Index p = 0; p < this->x_.size(); p += 2) this->x_[0][p] += this->length_ / 120.0;
    auto fresh = make_gauss<dim>(this->length_);
    expect_near(averaged(kept, this->x_, this->volumes_, this->field_),
                averaged(fresh, this->x_, this->volumes_, this->field_), 1e-14);
  }
  EXPECT_GT(kept.searches(), 1);
  EXPECT_LT(kept.searches(), calls / 6);
}

TYPED_TEST(GaussAveragers, NeedNoNewNeighboursWhileAllPointsMoveTogether) {
  constexpr int dim = TestFixture::axes;
  auto averager = make_gauss<dim>(this->length_);
  const Numbers before = averaged(averager, this->x_, this->volumes_, this->field_);
  for (int call = 0; call < 20; ++call) {
    for (int a = 0; a < dim; ++a)
      for (Index p = 0; p < this->x_.size(); ++p) this->x_[a][p] += 0.3 * this->length_;
    EXPECT_EQ(averaged(averager, this->x_, this->volumes_, this->field_), before);
  }
  EXPECT_EQ(averager.searches(), 1);
}

/// Three points in a line; the third moves away from the others, so that the average at the first changes.
double average_at_the_first(GaussAverager<2>& averager, double way) {
  Columns x(2);
  x.resize(3);
  x[0][1] = 0.5;
  x[0][2] = 1.0 + way;
  return averaged(averager, x, {1.0, 1.0, 1.0}, {0.0, 0.0, 1.0})[0];
}

TEST(GaussAverager, EvaluatesWeightsAnewWhenADistanceMayHaveChangedByTwiceTheirWay) {
  constexpr double last = GaussAverager<2>::weights_last;
  auto averager = make_gauss<2>(1.0), fresh = make_gauss<2>(1.0);
  const double start = average_at_the_first(averager, 0.0);
  EXPECT_EQ(average_at_the_first(averager, 1.99 * last), start);
  EXPECT_EQ(average_at_the_first(averager, 2.01 * last), average_at_the_first(fresh, 2.01 * last));
  EXPECT_NE(average_at_the_first(averager, 2.01 * last), start);
}

/// A specimen of 40 mm × 140 mm in which d is peaked in a band at 57°, 1.76 w thick at half its height.
struct Specimen {
  static constexpr double length = 1.5e-3; ///< l_c [m]
  Columns x;
  Numbers d, across; ///< across: distance from the middle of the band [m]

  /// @param thickness 1.76 w, in l_c [-]
  Specimen(const Counts<2>& counts, double thickness) : x(lattice<2>(counts, 40e-3 / counts[0])) {
    for (Index p = 0; p < x.size(); ++p) {
      across.push_back((x[0][p] - 20e-3) * along[1] - (x[1][p] - 70e-3) * along[0]);
      d.push_back(1.0 / square(std::cosh(across.back() / (thickness * length / 1.76))));
    }
  }
  static constexpr std::array<double, 2> along = {0.5446, 0.8387}; ///< cos and sin of 57°

  /// Largest error at d* of weights from before `move(x)`, against weights from after it.
  double error_of_kept_weights(const auto& move) const {
    const Numbers volumes(d.size(), 1.0);
    auto kept = make_gauss<2>(length), fresh = make_gauss<2>(length);
    averaged(kept, x, volumes, d);
    Columns moved = x;
    move(moved);
    return largest_difference(averaged(kept, moved, volumes, d), averaged(fresh, moved, volumes, d));
  }
};

TEST(GaussAverager, HasTheDocumentedErrorOfKeptWeights) {
  constexpr double way = 1.99 * GaussAverager<2>::weights_last * Specimen::length; // just before they are re-evaluated
  double thick = 0.0, thin = 0.0, squeezed = 0.0;
  for (const Counts<2>& counts : {Counts<2>{24, 84}, Counts<2>{32, 112}}) {
    for (double* largest : {&thick, &thin}) {
      const Specimen specimen(counts, largest == &thick ? 5.0 : 2.7);
      *largest = std::max(*largest, specimen.error_of_kept_weights([&](Columns& x) {
        for (Index p = 0; p < x.size(); ++p)
          for (int a = 0; a < 2; ++a) x[a][p] += specimen.across[p] < 0.0 ? way * Specimen::along[a] : 0.0;
      }));
      squeezed = std::max(squeezed, specimen.error_of_kept_weights([&](Columns& x) {
        for (Index p = 0; p < x.size(); ++p) x[1][p] *= 1.0 - way / 140e-3;
      }));
    }
  }
  EXPECT_NEAR(thick, 8.7e-5, 0.9e-5);
  EXPECT_NEAR(thin, 2.2e-4, 0.2e-4);
  EXPECT_NEAR(squeezed, 3.9e-6, 0.4e-6);
}

/// The sum over a lattice acts like a smooth average over l = √(second moment of its weights), since ∫ x² ω = l_c²/2 ∫
/// ω for Gauss's weight: averaging x² in the middle of a wide lattice adds l²/2.
double acting_length(double spacing, double length) {
  const Columns x = lattice<2>({41, 41}, spacing);
  const Index middle = (x.size() - 1) / 2;
  Numbers squares(static_cast<std::size_t>(x.size()));
  for (Index p = 0; p < x.size(); ++p) squares[p] = square(x[0][p] - x[0][middle]);
  auto averager = make_gauss<2>(length);
  return std::sqrt(2 * averaged(averager, x, Numbers(squares.size(), 1.0), squares)[middle]);
}

TEST(GaussAverager, ActsLikeAShorterLengthOnACoarseLattice) {
  const double length = 1.5e-3;
  EXPECT_NEAR(acting_length(2.5e-3, length) / length, 0.784, 5e-4);
  EXPECT_NEAR(acting_length(5e-3 / 3, length) / length, 0.994, 5e-4);
  EXPECT_NEAR(acting_length(1.25e-3, length) / length, 0.999, 5e-4);
}

} // namespace
} // namespace riedel
