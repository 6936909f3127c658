/// Eight doubles at once: loading, storing, arithmetic, comparison. Include pack.hpp, which also has the functions.
#pragma once

#include "core/base/exp_log.hpp"
#include "core/base/pack_name.hpp"
#include "core/base/types.hpp"

namespace riedel {

namespace detail {
constexpr int register_size = static_cast<int>(Register::size);
constexpr int registers = pack_size / register_size;
static_assert(registers * register_size == pack_size);
} // namespace detail

/// Eight truth values.
struct instructions::Mask {
  std::array<detail::Register::batch_bool_type, detail::registers> r;

  template <class F>
  static Mask make(F&& f) {
    Mask m;
    for (int i = 0; i < detail::registers; ++i) m.r[i] = f(i);
    return m;
  }
};

/// Eight doubles.
struct instructions::Pack {
  std::array<detail::Register, detail::registers> r;

  Pack() = default;
  Pack(double value) { r.fill(detail::Register(value)); } // NOLINT: a number converts to a pack of equal numbers
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

template <class Real>
using MaskOf = std::conditional_t<std::is_same_v<Real, Pack>, Mask, bool>;
template <class Real>
constexpr int lane_count = std::is_same_v<Real, Pack> ? pack_size : 1;

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
  return Mask::make([&](int i) { return a.r[i] < b.r[i]; });
}
inline Mask operator<=(const Pack& a, const Pack& b) {
  return Mask::make([&](int i) { return a.r[i] <= b.r[i]; });
}
inline Mask operator>(const Pack& a, const Pack& b) { return b < a; }
inline Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }
inline Pack operator-(const Pack& a) {
  return Pack::make([&](int i) { return -a.r[i]; });
}
inline Pack& Pack::operator+=(const Pack& b) { return *this = *this + b; }
inline Pack& Pack::operator*=(const Pack& b) { return *this = *this * b; }
inline Mask operator&&(const Mask& a, const Mask& b) {
  return Mask::make([&](int i) { return a.r[i] & b.r[i]; });
}
inline Mask operator||(const Mask& a, const Mask& b) {
  return Mask::make([&](int i) { return a.r[i] | b.r[i]; });
}
inline Mask operator!(const Mask& a) {
  return Mask::make([&](int i) { return ~a.r[i]; });
}
inline bool all(const Mask& m) {
  bool answer = true;
  for (const auto& r : m.r) answer = answer && xsimd::all(r);
  return answer;
}
inline bool any_lane(const Mask& m) { return !all(!m); }
inline bool all(bool m) { return m; }
inline bool any_lane(bool m) { return m; }
/// Lane by lane.
inline std::array<bool, pack_size> lanes(const Mask& m) {
  std::array<bool, pack_size> answer;
  for (int i = 0; i < detail::registers; ++i) m.r[i].store_unaligned(answer.data() + i * detail::register_size);
  return answer;
}

inline std::array<bool, 1> lanes(bool m) { return {m}; }

inline Pack select(const Mask& m, const Pack& yes, const Pack& no) {
  return Pack::make([&](int i) { return xsimd::select(m.r[i], yes.r[i], no.r[i]); });
}
inline double select(bool m, double yes, double no) { return m ? yes : no; }

} // namespace riedel
