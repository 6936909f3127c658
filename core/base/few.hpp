/// Two, four or eight doubles that belong to one point or node, worked on at once; and eight such rows made from
/// columns.
#pragma once

namespace riedel {

namespace detail {
/// Processors' vectors of doubles, which may stand wherever doubles may.
template <int Size>
struct LanesOf;
template <>
struct LanesOf<2> {
  using Type [[gnu::vector_size(16), gnu::aligned(8)]] = double;
};
template <>
struct LanesOf<4> {
  using Type [[gnu::vector_size(32), gnu::aligned(8)]] = double;
};
template <>
struct LanesOf<8> {
  using Type [[gnu::vector_size(64), gnu::aligned(8)]] = double;
};
} // namespace detail

template <int Size>
struct Few {
  using Lanes = typename detail::LanesOf<Size>::Type;
  Lanes lanes;

  Few() = default;
  Few(double value) {        // NOLINT: a number is a few equal numbers
    lanes = value - Lanes{}; // a vector of equal numbers
  }
  static Few load(const double* from) {
    Few few;
    few.lanes = *reinterpret_cast<const Lanes*>(from);
    return few;
  }
  void store(double* to) const { *reinterpret_cast<Lanes*>(to) = lanes; }
  Few& operator+=(const Few& b) {
    lanes += b.lanes;
    return *this;
  }
  Few& operator-=(const Few& b) {
    lanes -= b.lanes;
    return *this;
  }
};

template <int Size>
Few<Size> operator*(const Few<Size>& a, const Few<Size>& b) {
  Few<Size> product;
  product.lanes = a.lanes * b.lanes;
  return product;
}

template <int Size>
Few<Size> operator*(double a, const Few<Size>& b) {
  return Few<Size>(a) * b;
}

template <int Size>
Few<Size / 2> first_half(const Few<Size>& a) {
  Few<Size / 2> half;
  if constexpr (Size == 4)
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 0, 1);
  else
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 0, 1, 2, 3);
  return half;
}
template <int Size>
Few<Size / 2> second_half(const Few<Size>& a) {
  Few<Size / 2> half;
  if constexpr (Size == 4)
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 2, 3);
  else
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 4, 5, 6, 7);
  return half;
}
/// (a0, a1, b0, b1)
inline Few<4> joined(const Few<2>& a, const Few<2>& b) {
  Few<4> both;
  both.lanes = __builtin_shufflevector(a.lanes, b.lanes, 0, 1, 2, 3);
  return both;
}

} // namespace riedel
