/// The keys of a path: what each [[stage]] and each [[stage.leg]] may contain.
#pragma once

#include "core/case/checked_case.hpp"

namespace riedel {

inline constexpr std::string_view free_word = "free"; ///< of a measure that a stage does not prescribe
inline constexpr std::string_view hold_word = "hold"; ///< of one that is kept constant

std::string stage_prefix(int stage);        ///< "stage.1."
std::string leg_prefix(int stage, int leg); ///< "stage.1.leg.2."

Keys stage_keys(const std::string& prefix);
Keys leg_keys(const std::string& prefix);
/// Keys of the sine that is added to a measure's straight line, in a stage or in a leg.
Keys wave_keys(const std::string& prefix);
std::string swing_key(const std::string& measure); ///< "tau_swing", the amplitude
std::string phase_key(const std::string& measure); ///< "tau_phase", the angle at the start [deg]
/// Keys for as many stages and legs as the case has. @throws InputError for gaps in their numbers
Keys path_keys(const CaseFile& given);

} // namespace riedel
