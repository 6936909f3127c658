/// Basic types for all folders: indices, small vectors and matrices, half-open ranges.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace riedel {

using Index = std::int32_t; ///< number of a point or a node

template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;
template <int Dim>
using Counts = std::array<Index, Dim>; ///< cells, nodes or node indices along each axis

/// Half-open range [begin, end) of points or nodes.
struct Range {
  Index begin = 0, end = 0;
  [[nodiscard]] Index size() const { return end - begin; }
};

constexpr int pack_size = 8;      ///< doubles in a pack, whatever the width of the machine's registers
constexpr Index block_size = 256; ///< points handled by one virtual call; a multiple of pack_size

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }
constexpr double square(double x) { return x * x; }

} // namespace riedel
