/// Single steps of explicit Runge–Kutta methods for one point of a rate law, or eight. Each takes the rate at the
/// start, which is kept if a step is repeated with another length, and a function for the rate elsewhere.
#pragma once

#include "materials/kit/rate_law_traits.hpp"

namespace riedel {

/// The result of a step of a pair of methods.
template <class Real, std::size_t States>
struct PairStep {
  PointState<Real, States> end;
  PointState<Real, States> embedded; ///< of one order lower
};

/// Euler's method, order 1.
template <class Real, std::size_t States>
PointState<Real, States> moved(PointState<Real, States> point, const Rate<Real, States>& rate, double time) {
  point.stress = point.stress + Real(time) * rate.stress;
  for (std::size_t s = 0; s < States; ++s) point.state[s] += Real(time) * rate.state[s];
  return point;
}

/// Heun's method, order 2, with Euler's embedded.
template <class Real, std::size_t States, class RateAt>
PairStep<Real, States> heun(const PointState<Real, States>& start, const Rate<Real, States>& first, double time,
                            const RateAt& rate_at) {
  const PointState<Real, States> euler = moved(start, first, time);
  const Rate<Real, States> second = rate_at(euler);
  return {.end = moved(moved(start, first, 0.5 * time), second, 0.5 * time), .embedded = euler};
}

template <class Real, std::size_t States>
struct BogackiShampineStep : PairStep<Real, States> {
  Rate<Real, States> last; ///< at the end, which is the first of the next step
};

/// The pair of orders 3 and 2 of Bogacki & Shampine (1989), Applied Mathematics Letters 2(4), 321–325.
template <class Real, std::size_t States, class RateAt>
BogackiShampineStep<Real, States> bogacki_shampine(const PointState<Real, States>& start,
                                                   const Rate<Real, States>& first, double time,
                                                   const RateAt& rate_at) {
  const auto sum = [&](double a, const Rate<Real, States>& second, double b, const Rate<Real, States>& third,
                       double c) {
    return moved(moved(moved(start, first, a * time), second, b * time), third, c * time);
  };
  const Rate<Real, States> second = rate_at(moved(start, first, 0.5 * time));
  const Rate<Real, States> third = rate_at(moved(start, second, 0.75 * time));
  const PointState<Real, States> end = sum(2.0 / 9.0, second, 1.0 / 3.0, third, 4.0 / 9.0);
  const Rate<Real, States> last = rate_at(end);
  return {{.end = end, .embedded = moved(sum(7.0 / 24.0, second, 0.25, third, 1.0 / 3.0), last, 0.125 * time)}, last};
}

} // namespace riedel
