/// The expected work of a biaxial case, before it runs.
#pragma once

#include "apps/biaxial/case.hpp"
#include "materials/element/wave_speeds.hpp"

namespace riedel {

struct ExpectedWork {
  double points = 0.0;
  double time = 0.0;  ///< that the platen takes to the final strain [s]
  double limit = 0.0; ///< stable time step at the start [s]
  double step = 0.0;  ///< time step, under load [s]
  double steps = 0.0;
  double work = 0.0; ///< points times steps times their relative cost [-]

  [[nodiscard]] double seconds() const; ///< on one thread of a typical machine
};

/// Number of points of a biaxial case.
double expected_points(const BiaxialCase& values);

/// Wave speeds of the specimen under its confining pressure.
WaveSpeeds wave_speeds(const BiaxialCase& values, const Material& law);

/// Steps are those of the loaded specimen: most of a test runs near or past its peak.
ExpectedWork expected_work(const BiaxialCase& values, const WaveSpeeds& speeds);

} // namespace riedel
