/// The two number types a formula is written for: `double`, or `Pack`, eight doubles at once.
/// A formula that is a template on `Real` and calls the functions below runs on either. A mask of a double is a bool.
#pragma once

#include "core/base/pack_operators.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

/// Lane by lane, truncated towards zero.
inline std::array<Index, pack_size> whole_numbers(const Pack& a) {
  std::array<double, pack_size> lane;
  a.store(lane.data());
  std::array<Index, pack_size> answer;
  for (int k = 0; k < pack_size; ++k) answer[k] = static_cast<Index>(lane[k]);
  return answer;
}

inline double maximum(const Pack& a) {
  std::array<double, pack_size> lane;
  a.store(lane.data());
  return *std::max_element(lane.begin(), lane.end());
}
inline Pack exp(const Pack& a) {
  return Pack::make([&](int i) { return detail::exponential(a.r[i]); });
}
inline Pack log(const Pack& a) {
  return Pack::make([&](int i) { return detail::logarithm(a.r[i]); });
}
inline Pack cos(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::cos(a.r[i]); });
}
inline Pack acos(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::acos(a.r[i]); });
}
inline Pack sqrt(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::sqrt(a.r[i]); });
}
inline Pack abs(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::abs(a.r[i]); });
}
inline Pack floor(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::floor(a.r[i]); });
}
inline Pack min(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return xsimd::min(a.r[i], b.r[i]); });
}
inline Pack max(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return xsimd::max(a.r[i], b.r[i]); });
}
inline Pack copysign(const Pack& magnitude, const Pack& sign) {
  return Pack::make([&](int i) { return xsimd::copysign(magnitude.r[i], sign.r[i]); });
}
/// a^b for a ≥ 0; exp(b log a) is a third faster than a full pow and good to 1e-14 for the exponents of soil laws.
inline Pack pow(const Pack& a, const Pack& b) { return exp(b * log(a)); }

using std::abs;
using std::acos;
using std::copysign;
using std::cos;
using std::exp;
using std::floor;
using std::log;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

} // namespace riedel
