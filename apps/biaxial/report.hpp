/// The numerical results of a biaxial run: summary.json, and the final lines of the command.
#pragma once

#include "apps/biaxial/record.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

constexpr double quasi_static_limit = 0.05; ///< maximum kinetic over internal energy of a quasi-static run

/// How a run ended, besides what it knows itself.
struct BiaxialEnding {
  std::string status;     ///< "done", "interrupted", "failed"
  std::string reason;     ///< of a failure; empty: none
  double wall = 0.0;      ///< [s]
  int threads = 1;        ///< [-]
  double step_over_limit; ///< maximum time step over the stable one [-]
};

/// summary.json. Values that the run does not have are null; for a failed run also those of the band.
template <int Dim>
nlohmann::ordered_json biaxial_summary(const BiaxialRun<Dim>& run, const BiaxialCase& values,
                                       const BiaxialEnding& ending);

/// The figures of a summary for a terminal: how far the run came unless it is done, peak, residual angle, band,
/// energies and time, one line each. A dash marks a missing value.
std::string biaxial_text(const nlohmann::ordered_json& summary);

} // namespace riedel
