/// Packs of eight against the standard library, number by number.
#include "core/base/pack.hpp"

#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

using Eight = std::array<double, pack_size>;

Eight numbers(const Pack& pack) {
  Eight lanes;
  pack.store(lanes.data());
  return lanes;
}

/// Compares f on packs with g on their numbers, over numbers spread evenly in size from `from` to `to`.
template <class OnPack, class OnNumber>
void expect_same(const char* what, double from, double to, double tolerance, const OnPack& f, const OnNumber& g) {
  constexpr int count = 800;
  for (int i = 0; i < count; i += pack_size) {
    Eight x;
    for (int k = 0; k < pack_size; ++k) x[k] = from * std::pow(to / from, double(i + k) / count);
    for (const double sign : {1.0, -1.0}) {
      for (double& value : x) value = std::copysign(value, sign);
      const Eight y = numbers(f(Pack::load(x.data())));
      for (std::size_t k = 0; k < pack_size; ++k) {
        const double expected = g(x[k]);
        if (std::isnan(expected)) continue;
        EXPECT_NEAR(y[k], expected, tolerance * std::abs(expected)) << what << " of " << x[k];
      }
    }
  }
}

TEST(Pack, LoadsAndStoresEightNumbersInOrderFromAnywhere) {
  std::array<double, 20> memory;
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<double>(i);
  for (std::size_t offset = 0; offset < 5; ++offset) { // no alignment is asked for
    std::array<double, 20> copy{};
    Pack::load(memory.data() + offset).store(copy.data() + offset);
    for (std::size_t i = 0; i < copy.size(); ++i) {
      const bool inside = i >= offset && i < offset + pack_size;
      EXPECT_EQ(copy[i], inside ? memory[i] : 0.0);
    }
  }
  EXPECT_EQ(numbers(Pack(2.5)), (Eight{2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5}));
}

TEST(Pack, AddsMultipliesAndDividesLaneByLane) {
  const Eight a{1, -2, 3, 4, 0.5, 6e10, -7, 8}, b{3, 5, -7, 0.1, 9, 1e-3, 11, 13};
  const Pack A = Pack::load(a.data()), B = Pack::load(b.data());
  Pack sum = A, product = A;
  sum += B;
  product *= B;
  for (std::size_t k = 0; k < pack_size; ++k) {
    EXPECT_EQ(numbers(A + B)[k], a[k] + b[k]);
    EXPECT_EQ(numbers(A - B)[k], a[k] - b[k]);
    EXPECT_EQ(numbers(A * B)[k], a[k] * b[k]);
    EXPECT_EQ(numbers(A / B)[k], a[k] / b[k]);
    EXPECT_EQ(numbers(-A)[k], -a[k]);
    EXPECT_EQ(numbers(sum)[k], a[k] + b[k]);
    EXPECT_EQ(numbers(product)[k], a[k] * b[k]);
    EXPECT_EQ(numbers(min(A, B))[k], std::min(a[k], b[k]));
    EXPECT_EQ(numbers(max(A, B))[k], std::max(a[k], b[k]));
    EXPECT_EQ(numbers(copysign(A, B))[k], std::copysign(a[k], b[k]));
  }
}

TEST(Pack, ComparesAndSelectsLaneByLane) {
  const Eight a{1, 2, 3, 4, 5, 6, 7, 8}, b{8, 2, 1, 4, 9, 0, 7, 10};
  const Pack A = Pack::load(a.data()), B = Pack::load(b.data());
  const auto less = lanes(A < B), at_most = lanes(A <= B), more = lanes(A > B), at_least = lanes(A >= B);
  const auto equal = lanes(A <= B && A >= B);
  const Eight chosen = numbers(select(A < B, A, B));
  for (std::size_t k = 0; k < pack_size; ++k) {
    EXPECT_EQ(less[k], a[k] < b[k]);
    EXPECT_EQ(at_most[k], a[k] <= b[k]);
    EXPECT_EQ(more[k], a[k] > b[k]);
    EXPECT_EQ(at_least[k], a[k] >= b[k]);
    EXPECT_EQ(equal[k], a[k] == b[k]);
    EXPECT_EQ(chosen[k], std::min(a[k], b[k]));
  }
}

TEST(Pack, TellsWhetherAllLanesAreTrue) {
  for (std::size_t odd_one = 0; odd_one < pack_size; ++odd_one) {
    Eight a{1, 1, 1, 1, 1, 1, 1, 1};
    EXPECT_TRUE(all(Pack::load(a.data()) > Pack(0.0)));
    a[odd_one] = -1;
    EXPECT_FALSE(all(Pack::load(a.data()) > Pack(0.0))) << "lane " << odd_one;
    a[odd_one] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(all(Pack::load(a.data()) > Pack(0.0))) << "NaN in lane " << odd_one;
  }
}

TEST(Pack, HasTheFunctionsOfTheStandardLibrary) {
  constexpr double close = 1e-14;
  expect_same(
      "exp", 1e-6, 100, close, [](const Pack& x) { return exp(x); }, [](double x) { return std::exp(x); });
  expect_same(
      "log", 1e-12, 1e12, close, [](const Pack& x) { return log(x); }, [](double x) { return std::log(x); });
  expect_same(
      "cos", 1e-6, 4, close, [](const Pack& x) { return cos(x); }, [](double x) { return std::cos(x); });
  expect_same(
      "acos", 1e-6, 1, close, [](const Pack& x) { return acos(x); }, [](double x) { return std::acos(x); });
  expect_same(
      "sqrt", 1e-12, 1e12, close, [](const Pack& x) { return sqrt(x); }, [](double x) { return std::sqrt(x); });
  expect_same(
      "abs", 1e-12, 1e12, 0, [](const Pack& x) { return abs(x); }, [](double x) { return std::abs(x); });
  expect_same(
      "floor", 1e-3, 1e6, 0, [](const Pack& x) { return floor(x); }, [](double x) { return std::floor(x); });
}

TEST(Pack, HasExponentialsAndLogarithmsToTheLastBitsOverAllNumbers) {
  constexpr double close = 5e-16;
  const auto exp_pack = [](const Pack& x) { return exp(x); };
  expect_same("exp", 1e-9, 700, close, exp_pack, [](double x) { return std::exp(x); });
  const auto log_pack = [](const Pack& x) { return log(abs(x)); };
  const auto log_number = [](double x) { return std::log(std::abs(x)); };
  expect_same("log", 1e-300, 0.7, close, log_pack, log_number);
  expect_same("log", 1.5, 1e300, close, log_pack, log_number);
  expect_same("log", 0.7, 1.5, close, log_pack, log_number);
}

TEST(Pack, HasTheExponentialsAndLogarithmsOfZeroInfinityAndNaN) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Eight x{0.0, -inf, inf, 1.0, -800.0, 800.0, -0.0, nan}, e = numbers(exp(Pack::load(x.data())));
  const Eight expected_e{1.0, 0.0, inf, std::exp(1.0), 0.0, inf, 1.0, nan};
  const Eight y{0.0, -1.0, inf, 1.0, -inf, 1e-320, -0.0, nan}, l = numbers(log(Pack::load(y.data())));
  const Eight expected_l{-inf, nan, inf, 0.0, nan, -inf, -inf, nan};
  for (std::size_t k = 0; k < pack_size; ++k) {
    EXPECT_TRUE(std::isnan(expected_e[k]) ? std::isnan(e[k]) : e[k] == expected_e[k]) << "exp " << x[k] << ": " << e[k];
    EXPECT_TRUE(std::isnan(expected_l[k]) ? std::isnan(l[k]) : l[k] == expected_l[k]) << "log " << y[k] << ": " << l[k];
  }
  EXPECT_TRUE(std::isnan(numbers(pow(Pack(nan), Pack(0.3)))[0]));
}

TEST(Pack, CombinesTruthValuesAndFindsTheGreatestLane) {
  const Eight a{1, 2, 3, 4, 5, 6, 7, 8}, b{8, 2, 1, 4, 9, 0, 7, 10};
  const Mask less = Pack::load(a.data())<Pack::load(b.data()), large = Pack::load(a.data())> Pack(6.0);
  const auto either = lanes(less || large), neither = lanes(!(less || large));
  for (std::size_t k = 0; k < pack_size; ++k) {
    EXPECT_EQ(either[k], a[k] < b[k] || a[k] > 6.0);
    EXPECT_EQ(neither[k], !either[k]);
  }
  EXPECT_TRUE(any_lane(large));
  EXPECT_FALSE(any_lane(Pack::load(a.data()) > Pack(8.0)));
  EXPECT_EQ(maximum(Pack::load(b.data())), 10.0);
}

/// P/h_s from 1 Pa to 10 MPa with the exponents of the laws, and powers of (e − e_d)/(e_c − e_d).
TEST(Pack, HasPowersThatAreRightForTheExponentsOfSoilLaws) {
  for (const double exponent : {0.3, 0.5, 0.7, 1.0, 1.5, -0.5}) {
    const auto on_pack = [=](const Pack& x) { return pow(abs(x), Pack(exponent)); };
    const auto on_number = [=](double x) { return std::pow(std::abs(x), exponent); };
    expect_same("pow", 5e-9, 20.0, 1e-14, on_pack, on_number);
  }
  EXPECT_EQ(numbers(pow(Pack(0.0), Pack(0.3)))[0], 0.0);
}

} // namespace
} // namespace riedel::test
