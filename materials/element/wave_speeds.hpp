/// Speeds of compression waves in a law at rest and under load.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

/// Largest speeds of compression waves under isotropic pressure [m/s]; those of dense sand for a law that gives none.
struct WaveSpeeds {
  double at_start;
  double under_load; ///< with a vertical stress of ten times the pressure, as at a friction angle of 55°
};
WaveSpeeds wave_speeds(const Material& law, double pressure, double void_ratio);

} // namespace riedel
