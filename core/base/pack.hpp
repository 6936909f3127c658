/// The two number types a formula is written for: `double`, or `Pack`, eight doubles at once.
/// A formula that is a template on `Real` and calls the functions below runs on either. A mask of a double is a bool.
#pragma once

#include "core/base/pack_name.hpp"
#include "core/base/types.hpp"

#include <cmath>
#include <xsimd/xsimd.hpp>

namespace riedel {

namespace detail {
using Register = xsimd::batch<double>;
constexpr int register_size = static_cast<int>(Register::size);
constexpr int registers = pack_size / register_size;
static_assert(registers * register_size == pack_size);
} // namespace detail

/// Eight truth values.
struct instructions::Mask {
  std::array<detail::Register::batch_bool_type, detail::registers> r;
};

/// Eight doubles.
struct instructions::Pack {
  std::array<detail::Register, detail::registers> r;

  Pack() = default;
  Pack(double value) { r.fill(detail::Register(value)); } // NOLINT: a number is a pack of equal numbers
  static Pack load(const double* from) {                  ///< from eight contiguous doubles
    return make([&](int i) { return detail::Register::load_unaligned(from + i * detail::register_size); });
  }
  void store(double* to) const {
    for (int i = 0; i < detail::registers; ++i) r[i].store_unaligned(to + i * detail::register_size);
  }
  template <class F>
  static Pack make(F&& f) {
    Pack p;
    for (int i = 0; i < detail::registers; ++i) p.r[i] = f(i);
    return p;
  }
  Pack& operator+=(const Pack& b);
  Pack& operator*=(const Pack& b);
};

namespace detail {
inline Mask compare(const Pack& a, const Pack& b, auto&& f) {
  Mask m;
  for (int i = 0; i < registers; ++i) m.r[i] = f(a.r[i], b.r[i]);
  return m;
}
} // namespace detail

inline Pack operator+(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return a.r[i] + b.r[i]; });
}
inline Pack operator-(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return a.r[i] - b.r[i]; });
}
inline Pack operator*(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return a.r[i] * b.r[i]; });
}
inline Pack operator/(const Pack& a, const Pack& b) {
  return Pack::make([&](int i) { return a.r[i] / b.r[i]; });
}
inline Mask operator<(const Pack& a, const Pack& b) {
  return detail::compare(a, b, [](const auto& x, const auto& y) { return x < y; });
}
inline Mask operator<=(const Pack& a, const Pack& b) {
  return detail::compare(a, b, [](const auto& x, const auto& y) { return x <= y; });
}
inline Mask operator>(const Pack& a, const Pack& b) { return b < a; }
inline Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }
inline Pack operator-(const Pack& a) {
  return Pack::make([&](int i) { return -a.r[i]; });
}
inline Pack& Pack::operator+=(const Pack& b) { return *this = *this + b; }
inline Pack& Pack::operator*=(const Pack& b) { return *this = *this * b; }
inline Mask operator&&(const Mask& a, const Mask& b) {
  Mask m;
  for (int i = 0; i < detail::registers; ++i) m.r[i] = a.r[i] & b.r[i];
  return m;
}
inline bool all(const Mask& m) {
  bool answer = true;
  for (const auto& r : m.r) answer = answer && xsimd::all(r);
  return answer;
}
/// Lane by lane.
inline std::array<bool, pack_size> lanes(const Mask& m) {
  std::array<bool, pack_size> answer;
  for (int i = 0; i < detail::registers; ++i) m.r[i].store_unaligned(answer.data() + i * detail::register_size);
  return answer;
}

inline Pack select(const Mask& m, const Pack& yes, const Pack& no) {
  return Pack::make([&](int i) { return xsimd::select(m.r[i], yes.r[i], no.r[i]); });
}
inline double select(bool m, double yes, double no) { return m ? yes : no; }

inline Pack exp(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::exp(a.r[i]); });
}
inline Pack log(const Pack& a) {
  return Pack::make([&](int i) { return xsimd::log(a.r[i]); });
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
inline Pack pow(const Pack& a, const Pack& b) { return select(a > Pack(0.0), exp(b * log(a)), Pack(0.0)); }

using std::abs;
using std::copysign;
using std::exp;
using std::floor;
using std::log;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

} // namespace riedel
