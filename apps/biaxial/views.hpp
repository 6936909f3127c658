/// What runs of the biaxial test look like in tables.
#pragma once

#include "core/campaign/run_result.hpp"

namespace riedel {

/// Peak, residual angle, and the band at the end.
PageTable band_table(Runs runs);
/// Energies, mass, steps and time.
PageTable cost_table(Runs runs);

/// Strength and band of a run that is done, in one line.
std::string biaxial_outcome(const nlohmann::ordered_json& summary);

/// What tables take for granted of the summary of a run that is done. @throws InputError
void check_biaxial_summary(const nlohmann::ordered_json& summary);

} // namespace riedel
