/// Which keys of a biaxial case mean anything to the case's law.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

#include <optional>

namespace riedel {

/// What a law can use of what the test offers.
struct LawUses {
  std::string model;
  std::vector<std::string> averaged; ///< scalars that it can take averaged
  std::string why_local;             ///< without any: the reason, as a sentence that begins with the law's name
  bool void_ratio = true;
  bool strength = true; ///< it has parameters of strength, which a weak zone can lower
};

/// Of the law that the values name; none where it cannot be made.
std::optional<LawUses> law_uses(const Values& values, const Catalogue& catalogue);

/// Gives keys that mean nothing to the law the default that says so: no averaging, no patch.
/// @return what to tell of it, a line each
std::vector<std::string> fit_defaults(Keys& keys, const LawUses& uses, const CaseFile& given, const Values& values);

/// Refuses what was asked for and means nothing to the law.
void check_uses(const LawUses& uses, const CaseFile& given, const Values& values, const Catalogue& catalogue,
                std::vector<Finding>& errors);

/// Takes the keys out of the table that the law cannot use.
void leave_out_useless(Keys& keys, const LawUses& uses);

} // namespace riedel
