/// The stencil of a product over the axes: its nodes, their order, and their weights.
#pragma once

#include "core/state/stencils.hpp"

namespace riedel {

/// A function's value and its derivative with respect to the distance from the node.
template <class Real>
struct ValueGradient {
  Real value;    ///< [-]
  Real gradient; ///< [1/m]
};

/// Patches of `Nodes` × `Nodes` nodes in the plane, or as many lines in space as a patch may have rows.
template <int Nodes, int Dim>
constexpr PatchShape patch_of_product() {
  if constexpr (Nodes % 3 == 0) return {3, 3};
  return {Nodes == 2 ? power(Nodes, Dim - 1) : 2, Nodes};
}

/// Index of a product's entry: node i of a line along the first axis.
template <int Nodes, int Dim>
constexpr int entry_of(int line, int i) {
  constexpr PatchShape shape = patch_of_product<Nodes, Dim>();
  constexpr int across = Nodes / shape.length;
  const int patch = line / shape.rows * across + i / shape.length;
  return patch * shape.entries() + line % shape.rows * shape.length + i % shape.length;
}

/// Indices of the product's nodes.
/// @param base of the first node in each lane
template <int Nodes, int Dim>
void set_nodes(const Counts<Dim>& strides, const std::array<Index, pack_size>& base, StencilGroup<Dim>& group) {
  constexpr int lines = power(Nodes, Dim - 1);
  group.count = power(Nodes, Dim);
  group.shape = patch_of_product<Nodes, Dim>();
  const auto offset = [&](int line) {
    return line % Nodes * strides[1] + (Dim == 3 ? line / Nodes * strides[Dim - 1] : 0);
  };
  for (int r = 0; r < group.shape.rows; ++r) group.row[r] = offset(r);
  int patch = 0;
  for (int line = 0; line < lines; line += group.shape.rows)
    for (int i = 0; i < Nodes; i += group.shape.length) {
      std::array<Index, pack_size> lane;
      for (int k = 0; k < pack_size; ++k) lane[k] = base[k] + offset(line) + i;
      group.set_base(patch++, lane);
    }
}

/// Weights of the product's nodes.
template <int Nodes>
void fill_products(const std::array<std::array<ValueGradient<Pack>, Nodes>, 2>& factor, StencilEntries<2> entries) {
  const auto& [x, y] = factor;
  for (int j = 0; j < Nodes; ++j)
    for (int i = 0; i < Nodes; ++i) {
      const int entry = entry_of<Nodes, 2>(j, i);
      entries.set_value(entry, x[i].value * y[j].value);
      entries.set_gradient(entry, 0, x[i].gradient * y[j].value);
      entries.set_gradient(entry, 1, x[i].value * y[j].gradient);
    }
}
template <int Nodes>
void fill_products(const std::array<std::array<ValueGradient<Pack>, Nodes>, 3>& factor, StencilEntries<3> entries) {
  const auto& [x, y, z] = factor;
  for (int k = 0; k < Nodes; ++k)
    for (int j = 0; j < Nodes; ++j) {
      const Pack yz = y[j].value * z[k].value, dyz = y[j].gradient * z[k].value, ydz = y[j].value * z[k].gradient;
      for (int i = 0; i < Nodes; ++i) {
        const int entry = entry_of<Nodes, 3>(j + Nodes * k, i);
        entries.set_value(entry, x[i].value * yz);
        entries.set_gradient(entry, 0, x[i].gradient * yz);
        entries.set_gradient(entry, 1, x[i].value * dyz);
        entries.set_gradient(entry, 2, x[i].value * ydz);
      }
    }
}

} // namespace riedel
