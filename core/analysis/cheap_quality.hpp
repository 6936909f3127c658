/// Signs of unsound stresses that cost little to look at in every row of a history.
#pragma once

#include "core/step/state.hpp"

namespace riedel {

/// A specimen whose points were numbered row by row, and layer by layer.
struct SpecimenRows {
  std::size_t in_row, in_layer; ///< points
  Vec<2> across;                ///< unit vector along the rows
  double void_ratio, pressure;  ///< at the start [-], from the sides [Pa]
};

struct CheapQuality {
  /// Rms over the blocks beside the band of third differences over 8, from point to point along the width, of the
  /// change of void ratio, or of the volume ratio for a law without one: what alternates from column to column [-].
  double alternation = 0.0;
  std::int64_t stressless = 0; ///< points below 2 % of the confining pressure
  double block_velocity = 0.0; ///< mean velocity across the specimen of its upper fifth [m/s]
};

template <int Dim>
CheapQuality cheap_quality(const Body<Dim>& specimen, const SpecimenRows& rows);

/// How much a velocity swings: rms about the straight line through it, over its mean; not a number of fewer than four.
double swing(const std::vector<double>& u, const std::vector<double>& velocity);

} // namespace riedel
