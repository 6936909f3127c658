/// Two, four or eight doubles of one point or node, processed at once; and eight such rows made from columns.
#pragma once

namespace riedel {

namespace detail {
/// The processor's vectors of doubles, allowed at any address where a double is allowed.
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
struct ShortVector {
  using Lanes = typename detail::LanesOf<Size>::Type;
  Lanes lanes;

  ShortVector() = default;
  ShortVector(double value) { // NOLINT: a number converts to equal numbers
    lanes = value - Lanes{};  // a vector of equal numbers
  }
  static ShortVector load(const double* from) {
    ShortVector few;
    few.lanes = *reinterpret_cast<const Lanes*>(from);
    return few;
  }
  void store(double* to) const { *reinterpret_cast<Lanes*>(to) = lanes; }
  ShortVector& operator+=(const ShortVector& b) {
    lanes += b.lanes;
    return *this;
  }
  ShortVector& operator-=(const ShortVector& b) {
    lanes -= b.lanes;
    return *this;
  }
};

template <int Size>
ShortVector<Size> operator*(const ShortVector<Size>& a, const ShortVector<Size>& b) {
  ShortVector<Size> product;
  product.lanes = a.lanes * b.lanes;
  return product;
}

template <int Size>
ShortVector<Size> operator*(double a, const ShortVector<Size>& b) {
  return ShortVector<Size>(a) * b;
}

template <int Size>
ShortVector<Size / 2> first_half(const ShortVector<Size>& a) {
  ShortVector<Size / 2> half;
  if constexpr (Size == 4)
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 0, 1);
  else
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 0, 1, 2, 3);
  return half;
}
template <int Size>
ShortVector<Size / 2> second_half(const ShortVector<Size>& a) {
  ShortVector<Size / 2> half;
  if constexpr (Size == 4)
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 2, 3);
  else
    half.lanes = __builtin_shufflevector(a.lanes, a.lanes, 4, 5, 6, 7);
  return half;
}
/// (a0, a1, b0, b1)
inline ShortVector<4> joined(const ShortVector<2>& a, const ShortVector<2>& b) {
  ShortVector<4> both;
  both.lanes = __builtin_shufflevector(a.lanes, b.lanes, 0, 1, 2, 3);
  return both;
}

} // namespace riedel
