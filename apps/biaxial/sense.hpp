/// Numbers of a biaxial case that are allowed but make no sense, as when a unit is forgotten: 1.5 for 1.5 mm.
#pragma once

#include "apps/biaxial/case.hpp"
#include "apps/biaxial/expected_work.hpp"
#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Refuses numbers that are certainly absurd and warns of those that probably are, with the value that shows it. Checks
/// only a case without errors.
void check_sense(const CaseFile& given, const BiaxialCase& values, const Catalogue& catalogue, Diagnostics& found);

/// Points, steps and time, from the law's own wave speed.
ExpectedWork expected_work_of(const BiaxialCase& values, const Catalogue& catalogue);

/// "2016 points, 41000 steps of 2.1e-06 s, about 40 s on one thread"
std::string expected_text(const ExpectedWork& expected);

/// The warning of a time step over the stable one, which a run itself gives when it begins. Empty: none.
std::vector<Finding> time_step_doubts(const BiaxialCase& values, const ExpectedWork& expected);

} // namespace riedel
