/// How much a biaxial case is to compute, before it runs.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

struct ExpectedWork {
  double points = 0.0;
  double time = 0.0;  ///< that the platen takes to the final strain [s]
  double limit = 0.0; ///< stable time step at the start [s]
  double step = 0.0;  ///< time step [s]
  double steps = 0.0;
  double neighbours = 0.0; ///< of a point, in the average
  double work = 0.0;       ///< points times steps times what each takes beside the others [-]

  [[nodiscard]] double seconds() const; ///< on one thread of a usual machine
  [[nodiscard]] double bytes() const;   ///< of memory
};

/// Number of points of a biaxial case.
double expected_points(const Values& values);

/// Greatest speed of a compression wave in the specimen at its start [m/s]; of dense sand for a law that does not tell.
double wave_speed_at_start(const Values& values, const Material& law);

/// @param wave_speed [m/s]
ExpectedWork expected_work(const Values& values, double wave_speed);

/// "40 s", "3.2 h", "12 days"
std::string span_text(double seconds);

} // namespace riedel
