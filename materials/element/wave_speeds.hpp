/// How fast compression waves run in a law at rest and under load.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

/// Greatest speeds of compression waves under isotropic pressure [m/s]; those of dense sand for a law that does not
/// tell.
struct WaveSpeeds {
  double at_start;
  double under_load; ///< with a vertical stress of ten times the pressure, as at 55° of friction
};
WaveSpeeds wave_speeds(const Material& law, double pressure, double void_ratio);

} // namespace riedel
