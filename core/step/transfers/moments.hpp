/// Moments of stencils about their points.
#pragma once

#include "core/step/pack_matrix.hpp"
#include "core/step/state.hpp"

namespace riedel {

template <int Dim>
struct Moments {
  StencilEntries<Dim> first; ///< the stencils with N_ip (x_i − x_p) in the place of ∇N_ip [m]
  PackMatrix<Dim> second;    ///< D_p = Σ_i N_ip (x_i − x_p) ⊗ (x_i − x_p) [m²]
};

/// @param stencils of eight points from p on
/// @param room for the first moments: Dim times eight numbers for each entry
template <int Dim>
Moments<Dim> moments_of(const StencilEntries<Dim>& stencils, const Grid<Dim>& grid, const Points<Dim>& points, Index p,
                        double* room);

/// Of this thread, made by `locate_points`.
template <int Dim>
double* room_for_moments(State<Dim>& state) {
  return state.moments[static_cast<std::size_t>(this_thread())].data();
}

} // namespace riedel
