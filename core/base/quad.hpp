/// Four doubles worked on at once: half a pack, for records that fill no whole one.
#pragma once

#include "core/base/pack.hpp"

#include <cstring>

namespace riedel {

struct Quad {
  typedef double Lanes __attribute__((vector_size(4 * sizeof(double)))); // NOLINT: g++ takes the attribute here only
  Lanes lanes;

  static constexpr int size = 4;
  Quad() = default;
  Quad(double value) : lanes{value, value, value, value} {} // NOLINT: a number is a quad of equal numbers
  static Quad load(const double* from) {
    Quad q;
    std::memcpy(&q.lanes, from, sizeof(Lanes));
    return q;
  }
  void store(double* to) const { std::memcpy(to, &lanes, sizeof(Lanes)); }
  Quad& operator+=(const Quad& b) {
    lanes += b.lanes;
    return *this;
  }
};

inline Quad operator*(const Quad& a, const Quad& b) {
  Quad product;
  product.lanes = a.lanes * b.lanes;
  return product;
}

} // namespace riedel
