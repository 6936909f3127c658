/// Manufactured solutions: a chosen motion, and the body force that makes it the exact solution.
#pragma once

#include "apps/verify/block.hpp"

namespace riedel {

/// The law `neo_hookean` at the start.
struct ElasticConstants {
  double modulus; ///< E [Pa]
  double poisson; ///< ν [-]
  double density; ///< ρ at the start [kg/m³]

  [[nodiscard]] double lambda() const { return modulus * poisson / ((1 + poisson) * (1 - 2 * poisson)); } ///< [Pa]
  [[nodiscard]] double mu() const { return modulus / (2 * (1 + poisson)); }                               ///< [Pa]
  /// Speed of pressure waves [m/s]
  [[nodiscard]] double wave_speed() const { return std::sqrt((lambda() + 2 * mu()) / density); }
  /// Speed of waves in a thin bar, √(E/ρ) [m/s]
  [[nodiscard]] double bar_speed() const { return std::sqrt(modulus / density); }
  [[nodiscard]] std::map<std::string, Value> parameters() const {
    return {{"youngs_modulus", modulus}, {"poissons_ratio", poisson}, {"density", density}};
  }
};

template <int Dim>
struct Manufactured {
  VerifyBlock<Dim> block;
  std::vector<Side> rollers = {};
  double duration; ///< [s]
  double fastest;  ///< speed of the fastest wave [m/s]
  Course<Dim> displacement;
  VectorField<Dim> velocity_at_start;
  std::function<Mat<Dim>(const Vec<Dim>& X)> gradient_at_start = {}; ///< F; none: undeformed
  Course<Dim> body_force;
};

/// The error is that of the points' displacements over the whole time.
template <int Dim>
VerifyRun run_manufactured(const VerifyCase& given, const Manufactured<Dim>& solution);

} // namespace riedel
