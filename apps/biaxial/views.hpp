/// Tables of runs of the biaxial test.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Peak, residual angle, and the band at the end.
PageTable band_table(Runs runs);
/// Energies, mass, steps and time.
PageTable cost_table(Runs runs);

/// Strength and band of a completed run, in one line.
std::string biaxial_outcome(const nlohmann::ordered_json& summary);

/// Checks what the tables need of the summary of a completed run. @throws InputError
void check_biaxial_summary(const nlohmann::ordered_json& summary);

} // namespace riedel
