/// How much a biaxial case is to compute, before it runs.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

struct ExpectedWork {
  double points = 0.0;
  double time = 0.0;  ///< that the platen takes to the final strain [s]
  double limit = 0.0; ///< stable time step at the start [s]
  double step = 0.0;  ///< time step, under load [s]
  double steps = 0.0;
  double work = 0.0; ///< points times steps times what each takes beside the others [-]

  [[nodiscard]] double seconds() const; ///< on one thread of a usual machine
};

/// Until a plate, which rises to its speed [m/s] smoothly over `ramp` [s], has come so far [m]. @return [s]
double time_to(double distance, double speed, double ramp);

/// Number of points of a biaxial case.
double expected_points(const Values& values);

/// Greatest speeds of compression waves in the specimen [m/s]; those of dense sand for a law that does not tell.
struct WaveSpeeds {
  double at_start;
  double under_load; ///< with a vertical stress of ten times the pressure, as at 55° of friction
};
WaveSpeeds wave_speeds(const Material& law, double pressure, double void_ratio);
WaveSpeeds wave_speeds(const Values& values, const Material& law);

/// Steps are those of the loaded specimen: most of a test runs near or past its peak.
ExpectedWork expected_work(const Values& values, const WaveSpeeds& speeds);

/// "40 s", "3.2 h", "12 days"
std::string span_text(double seconds);

} // namespace riedel
