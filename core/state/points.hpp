/// The material points of one body: one column per component of each field, so that eight points are read at once.
#pragma once

#include "core/base/columns.hpp"

#include <numeric>

namespace riedel {

/// Dim × Dim tensors are stored row by row: component(i, j) = i Dim + j. In plane strain mass, volume and force are per
/// metre of thickness.
template <int Dim>
struct Points {
  Columns position{Dim};                   ///< x_p [m]
  Columns velocity{Dim};                   ///< v_p [m/s]
  Columns mass{1};                         ///< m_p [kg or kg/m]
  Columns volume{1};                       ///< V_p [m³ or m²]
  Columns initial_volume{1};               ///< V_p at the start
  Columns half_size{Dim};                  ///< half edges of the point's initial domain, along the axes [m]
  Columns deformation_gradient{Dim * Dim}; ///< F_p [-]
  Columns velocity_gradient{Dim * Dim};    ///< L_p = ∂v/∂x [1/s]
  Columns stress{6};                       ///< Cauchy stress, tension positive, Mandel components [Pa]
  Columns transfer_data{0};                ///< data of the velocity transfer for each point
  Columns state{0};                        ///< the law's state variables, in the order it declares them
  Columns rate_norm{1};                    ///< ‖D‖ [1/s]
  Columns averaged{1};                     ///< non-local average of the scalar the law names
  Columns shear_strain{1};                 ///< ∫ √2 ‖dev D‖ dt, γ in simple shear [-]
  Columns work{1};                         ///< ∫ V_p σ:D dt, done on the point by its stress [J or J/m]
  Columns expansion{0};                    ///< the stress filter's addition to tr L_p, empty without it [1/s]
  Columns scheme_data{0};                  ///< data of the interpolation scheme for each point
  std::vector<Index> id;                   ///< initial number of the point, kept when points are sorted
  std::vector<Index> place;                ///< present position of the point with a given id: id[place[i]] = i

  [[nodiscard]] Index size() const { return mass.size(); }

  /// @param states number of state columns that the body's law declares
  void resize(Index size, int states);

  /// Every field except the numbering, for sorting and for checkpoints.
  [[nodiscard]] std::array<Columns*, 17> fields() {
    return {&position,
            &velocity,
            &mass,
            &volume,
            &initial_volume,
            &half_size,
            &deformation_gradient,
            &velocity_gradient,
            &stress,
            &transfer_data,
            &state,
            &rate_norm,
            &averaged,
            &shear_strain,
            &work,
            &expansion,
            &scheme_data};
  }

  [[nodiscard]] Vec<Dim> position_of(Index p) const { return vector(position, p); }
  [[nodiscard]] Vec<Dim> velocity_of(Index p) const { return vector(velocity, p); }
  [[nodiscard]] Mat<Dim> deformation_gradient_of(Index p) const { return matrix(deformation_gradient, p); }
  [[nodiscard]] Mat<Dim> velocity_gradient_of(Index p) const { return matrix(velocity_gradient, p); }

private:
  static Vec<Dim> vector(const Columns& field, Index p) {
    Vec<Dim> v;
    for (int a = 0; a < Dim; ++a) v[a] = field[a][p];
    return v;
  }
  static Mat<Dim> matrix(const Columns& field, Index p) {
    Mat<Dim> m;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) m(i, j) = field[i * Dim + j][p];
    return m;
  }
};

template <int Dim>
void Points<Dim>::resize(Index size, int states) {
  state = Columns(states);
  for (Columns* field : fields()) field->resize(size);
  for (int a = 0; a < Dim; ++a) deformation_gradient.fill(a * Dim + a, 1.0);
  id.resize(static_cast<std::size_t>(size));
  std::iota(id.begin(), id.end(), 0);
  place = id;
}

} // namespace riedel
