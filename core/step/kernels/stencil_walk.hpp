/// Loops over stencils in both directions of the transfer, and the rows of numbers that they carry.
#pragma once

#include "core/base/transpose_8x4.hpp"
#include "core/state/nodes.hpp"
#include "core/state/stencils.hpp"

namespace riedel {

/// The parts of a stencil that a transfer uses.
enum class Use { weights, gradients, both };

/// Calls `body` with the shape of the stencil's patches as a constant.
template <std::size_t First = 0, class Body>
void with_shape(const PatchShape& shape, const Body& body) {
  if constexpr (First + 1 == patch_shapes.size()) {
    body(std::integral_constant<std::size_t, First>());
  } else {
    if (shape == patch_shapes[First]) return body(std::integral_constant<std::size_t, First>());
    with_shape<First + 1>(shape, body);
  }
}

/// A lane of a patch. Advances by steps, so that all its weights are at constant offsets from its position.
template <std::size_t ShapeNumber, int Dim>
struct PatchLane {
  static constexpr PatchShape shape = patch_shapes[ShapeNumber];
  static constexpr int entries = shape.entries();
  const Index* base;
  const double *value, *gradient;
  std::array<Index, shape.rows> row;

  PatchLane(const StencilEntries<Dim>& stencil, Index lane)
      : base(stencil.base + lane), value(stencil.value + lane), gradient(stencil.gradient + lane) {
    std::copy_n(stencil.row.begin(), shape.rows, row.begin());
  }
  void to_next_lane() { ++base, ++value, ++gradient; }
  void to_next_patch() {
    base += pack_size;
    value += entries * pack_size;
    gradient += entries * Dim * pack_size;
  }
  [[nodiscard]] double value_of(int entry) const { return value[entry * pack_size]; }
  [[nodiscard]] double gradient_of(int entry, int axis) const { return gradient[(entry * Dim + axis) * pack_size]; }

  /// Calls `visit(entry, node)` for the lane's nodes.
  template <class Node, class Visit>
  void for_each_node(Node* nodes, const Visit& visit) const {
    for (int r = 0; r < shape.rows; ++r) {
      Node* const in_row = nodes + (*base + row[r]);
      for (int i = 0; i < shape.length; ++i) visit(r * shape.length + i, in_row[i]);
    }
  }
};

/// Eight rows for vectors along axes: in the plane two vectors fill a row, in space one.
template <int Dim>
struct GradientRows {
  static constexpr int lanes = sizeof(VectorLanes<Dim>) / sizeof(double), in_row = 4 / lanes;
  std::array<Transpose8x4, (Dim + in_row - 1) / in_row> rows;

  [[nodiscard]] const double* of(int axis, Index lane) const {
    return rows[axis / in_row].row(lane) + axis % in_row * lanes;
  }
  /// @param vectors component i of the vector along axis a is vectors[a][i]
  void put(const std::array<std::array<Pack, Dim>, Dim>& vectors) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::array<Pack, 4> columns;
      for (int c = 0; c < 4; ++c) {
        const int axis = static_cast<int>(r) * in_row + c / lanes, i = c % lanes;
        columns[c] = i < Dim ? vectors[axis][i] : Pack(0.0);
      }
      rows[r].put(columns);
    }
  }
  [[nodiscard]] std::array<std::array<Pack, Dim>, Dim> vectors() const {
    std::array<std::array<Pack, Dim>, Dim> answer;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::array<Pack, 4> columns = rows[r].columns();
      for (int c = 0; c < 4; ++c)
        if (c % lanes < Dim) answer[static_cast<int>(r) * in_row + c / lanes][c % lanes] = columns[c];
    }
    return answer;
  }
};

} // namespace riedel
