/// Indicators of poor stresses that are cheap enough to evaluate in every row of a history.
#pragma once

#include "core/step/state.hpp"

namespace riedel {

/// A specimen whose points are numbered row by row and layer by layer.
struct SpecimenRows {
  std::size_t in_row, in_layer; ///< points
  Vec<2> across;                ///< unit vector along the rows
  double void_ratio, pressure;  ///< at the start [-], from the sides [Pa]
};

struct CheapQuality {
  /// Third difference over 8, from point to point along the width, of the change of void ratio (of the volume ratio for
  /// a law without one): rms over the blocks beside the band. Measures what alternates from column to column [-].
  double alternation = 0.0;
  std::int64_t stressless = 0; ///< points below 2 % of the confining pressure
  double block_velocity = 0.0; ///< mean velocity of the upper fifth, across the specimen [m/s]
};

template <int Dim>
CheapQuality cheap_quality(const Body<Dim>& specimen, const SpecimenRows& rows);

/// Fluctuation of a velocity: rms about its regression line over its mean; NaN for fewer than four values.
double swing(const std::vector<double>& u, const std::vector<double>& velocity);

} // namespace riedel
