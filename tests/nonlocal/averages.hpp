/// Common parts of the tests of averagers: numbers, a reference sum, motions of points.
#pragma once

#include "nonlocal/clouds.hpp"

#include "core/interface/nonlocal_averager.hpp"

#include <gtest/gtest.h>

namespace riedel {

using Numbers = std::vector<double>;

inline Numbers random_numbers(Index count, double lower, double upper, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(lower, upper);
  Numbers answer(static_cast<std::size_t>(count));
  for (double& x : answer) x = number(random);
  return answer;
}

template <int Dim>
Numbers averaged(NonlocalAverager<Dim>& averager, const Columns& x, const Numbers& volumes, const Numbers& field) {
  Numbers answer(field.size());
  averager.update_neighbours(x);
  averager.average(volumes.data(), field.data(), answer.data());
  return answer;
}

/// The sum over all pairs as in the paper, with the cut-off, written without the library's weight.
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

inline double largest_difference(const Numbers& a, const Numbers& b) {
  double largest = 0.0;
  for (std::size_t p = 0; p < a.size(); ++p) largest = std::max(largest, std::abs(a[p] - b[p]));
  return largest;
}

inline void expect_near(const Numbers& a, const Numbers& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t p = 0; p < a.size(); ++p) ASSERT_NEAR(a[p], b[p], tolerance) << "at point " << p;
}

/// Moves every point differently, at most by `step` along each axis.
template <int Dim>
void shake(Columns& x, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> way(-step, step);
  for (int a = 0; a < Dim; ++a)
    for (Index p = 0; p < x.size(); ++p) x[a][p] += way(random);
}

} // namespace riedel
