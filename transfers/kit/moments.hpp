/// Moments of stencils about their points.
#pragma once

#include "core/base/pack_matrix.hpp"
#include "core/step/state.hpp"

namespace riedel {

template <int Dim>
struct Moments {
  StencilEntries<Dim> first; ///< the stencils with N_ip (x_i − x_p) instead of ∇N_ip [m]
  PackMatrix<Dim> second;    ///< D_p = Σ_i N_ip (x_i − x_p) ⊗ (x_i − x_p) [m²]
};

/// x_i − x_p of eight nodes and points.
template <int Dim>
std::array<Pack, Dim> distances(const Grid<Dim>& grid, const Counts<Dim>& strides, const Index* base, Index row,
                                const Points<Dim>& points, Index p) {
  std::array<double, pack_size> number;
  for (int k = 0; k < pack_size; ++k) number[k] = base[k] + row;
  Pack rest = Pack::load(number.data());
  std::array<Pack, Dim> index;
  for (int a = Dim - 1; a > 0; --a) {
    index[a] = floor((rest + Pack(0.5)) * Pack(1.0 / strides[a]));
    rest = rest - index[a] * Pack(strides[a]);
  }
  index[0] = rest;
  std::array<Pack, Dim> r;
  for (int a = 0; a < Dim; ++a)
    r[a] = Pack(grid.origin[a]) + index[a] * Pack(grid.cell[a]) - Pack::load(points.position[a] + p);
  return r;
}

/// @param stencils of eight points from p on
/// @param room for the first moments: Dim times eight numbers per entry
template <int Dim>
Moments<Dim> moments_of(const StencilEntries<Dim>& stencils, const Grid<Dim>& grid, const Points<Dim>& points, Index p,
                        double* room) {
  Moments<Dim> moments{.first = stencils, .second = {}};
  moments.first.gradient = room;
  PackMatrix<Dim>& D = moments.second;
  for (auto& line : D) line.fill(Pack(0.0));
  const Counts<Dim> strides = grid.strides();
  const Index* base = stencils.base;
  for (int entry = 0; entry < stencils.count; base += pack_size)
    for (int row = 0; row < stencils.shape.rows; ++row) {
      std::array<Pack, Dim> r = distances<Dim>(grid, strides, base, stencils.row[row], points, p);
      for (int i = 0; i < stencils.shape.length; ++i, ++entry, r[0] += Pack(grid.cell[0])) {
        const Pack N = Pack::load(stencils.value + entry * pack_size);
        for (int a = 0; a < Dim; ++a) {
          const Pack moment = N * r[a];
          moments.first.set_gradient(entry, a, moment);
          for (int b = 0; b <= a; ++b) D[a][b] += moment * r[b];
        }
      }
    }
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < a; ++b) D[b][a] = D[a][b];
  return moments;
}

} // namespace riedel
