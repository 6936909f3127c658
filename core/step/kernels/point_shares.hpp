/// What eight points have to give to the grid.
#pragma once

#include "core/step/kernels/scatter.hpp"

namespace riedel {

constexpr int mandel(int i, int j) { return i == j ? i : i + j + 2; } ///< place of σ_ij in the order 11 22 33 12 13 23

/// m_p v_p and m_p of eight points.
template <int Dim>
void put_mass_and_momentum(const Points<Dim>& points, Index p, Shares<Dim>& shares) {
  const Pack m = Pack::load(points.mass[0] + p);
  std::array<Pack, 4> columns;
  columns.fill(Pack(0.0));
  columns[NodeSums<Dim>::mass_at] = m;
  for (int a = 0; a < Dim; ++a) columns[a] = m * Pack::load(points.velocity[a] + p);
  shares.mass.put(columns);
}

/// −V_p (σ_p + p I), the stress in excess of the confining pressure.
template <int Dim>
void put_forces(const Points<Dim>& points, Index p, double pressure, Shares<Dim>& shares) {
  const Pack V = -Pack::load(points.volume[0] + p);
  std::array<std::array<Pack, Dim>, Dim> force;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j <= i; ++j) {
      const Pack stress = Pack::load(points.stress[mandel(i, j)] + p);
      force[i][j] = force[j][i] = i == j ? V * (stress + Pack(pressure)) : V * stress * Pack(std::numbers::sqrt2 / 2);
    }
  shares.force.put(force);
}

} // namespace riedel
