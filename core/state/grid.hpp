/// The background grid: regular, one cell size per axis.
#pragma once

#include "core/base/types.hpp"

#include <limits>

namespace riedel {

/// Rows of nodes between which material can lie along one axis: all nodes from the first down, or from the last up,
/// move as one.
struct Walls {
  static constexpr Index none_below = std::numeric_limits<Index>::min(), none_above = std::numeric_limits<Index>::max();
  Index first = none_below, last = none_above;
};

/// Nodes are numbered with the first axis fastest.
template <int Dim>
struct Grid {
  Vec<Dim> origin = Vec<Dim>::Zero();  ///< position of node (0, 0[, 0]) [m]
  Vec<Dim> cell = Vec<Dim>::Ones();    ///< cell size h [m]
  Vec<Dim> stretch = Vec<Dim>::Ones(); ///< h over its initial value, for a grid that follows a platen [-]
  Counts<Dim> nodes{};                 ///< nodes along each axis
  std::array<Walls, Dim> walls{};      ///< along each axis, for schemes whose functions end at a boundary

  [[nodiscard]] Index node_count() const {
    Index count = 1;
    for (const Index n : nodes) count *= n;
    return count;
  }
  [[nodiscard]] Counts<Dim> strides() const {
    Counts<Dim> stride{};
    stride[0] = 1;
    for (std::size_t a = 1; a < Dim; ++a) stride[a] = stride[a - 1] * nodes[a - 1];
    return stride;
  }
  [[nodiscard]] Index node(const Counts<Dim>& index) const {
    Index number = 0;
    for (int a = Dim - 1; a >= 0; --a) number = number * nodes[a] + index[a];
    return number;
  }
  [[nodiscard]] Counts<Dim> index(Index node) const {
    Counts<Dim> answer{};
    for (std::size_t a = 0; a < Dim; ++a) {
      answer[a] = node % nodes[a];
      node /= nodes[a];
    }
    return answer;
  }
  [[nodiscard]] Vec<Dim> position(const Counts<Dim>& index) const {
    Vec<Dim> x = origin;
    for (int a = 0; a < Dim; ++a) x[a] += cell[a] * index[a];
    return x;
  }
};

} // namespace riedel
