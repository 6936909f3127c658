/// Matrices of eight points at once.
#pragma once

#include "core/base/columns.hpp"
#include "core/base/pack.hpp"

namespace riedel {

/// Entries of a Dim × Dim matrix, row by row, of eight points.
template <int Dim>
using PackMatrix = std::array<std::array<Pack, Dim>, Dim>;

/// Loads eight points from p on, from columns of components row by row.
template <int Dim>
PackMatrix<Dim> load_matrix(const Columns& columns, Index p) {
  PackMatrix<Dim> matrix;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) matrix[i][j] = Pack::load(columns[i * Dim + j] + p);
  return matrix;
}

inline Pack determinant(const PackMatrix<2>& a) { return a[0][0] * a[1][1] - a[0][1] * a[1][0]; }
inline Pack determinant(const PackMatrix<3>& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// det(A) A⁻ᵀ
inline PackMatrix<2> cofactor(const PackMatrix<2>& a) { return {{{a[1][1], -a[1][0]}, {-a[0][1], a[0][0]}}}; }
inline PackMatrix<3> cofactor(const PackMatrix<3>& a) {
  PackMatrix<3> c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
      c[i][j] = a[k][m] * a[l][n] - a[k][n] * a[l][m];
    }
  return c;
}

/// Aᵀ B
template <std::size_t Dim>
std::array<std::array<Pack, Dim>, Dim> transposed_times(const std::array<std::array<Pack, Dim>, Dim>& a,
                                                        const std::array<std::array<Pack, Dim>, Dim>& b) {
  std::array<std::array<Pack, Dim>, Dim> c;
  for (std::size_t i = 0; i < Dim; ++i)
    for (std::size_t j = 0; j < Dim; ++j) {
      c[i][j] = a[0][i] * b[0][j];
      for (std::size_t k = 1; k < Dim; ++k) c[i][j] += a[k][i] * b[k][j];
    }
  return c;
}

} // namespace riedel
