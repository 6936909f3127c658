/// What a biaxial run leaves in numbers: summary.json, and the lines that end the command.
#pragma once

#include "apps/biaxial/record.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

constexpr double quasi_static_limit = 0.05; ///< greatest kinetic over internal energy of a quasi-static run

/// How a run came to its end, beside what it knows itself.
struct BiaxialEnding {
  std::string status;     ///< "done", "interrupted", "failed"
  std::string reason;     ///< why it failed; empty: it did not
  double wall = 0.0;      ///< [s]
  int threads = 1;        ///< [-]
  double step_over_limit; ///< greatest time step over the stable one [-]
};

/// summary.json. What the run cannot have is null; of a failed run that is the band, too.
template <int Dim>
nlohmann::ordered_json biaxial_summary(const BiaxialRun<Dim>& run, const BiaxialCase& values,
                                       const BiaxialEnding& ending);

/// The figures of a summary for a terminal: how far the run came unless it is done, peak, residual angle, band,
/// energies and time, a line each. A dash stands for what it does not have.
std::string biaxial_text(const nlohmann::ordered_json& summary);

} // namespace riedel
