/// Which keys of a biaxial case its law can use.
#pragma once

#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

#include <optional>

namespace riedel {

/// The features of the test that a law can use.
struct LawUses {
  std::string model;
  std::vector<std::string> averaged; ///< scalars that it can take averaged
  std::string why_local;             ///< if there are none: the reason, as a sentence that begins with the law's name
  bool void_ratio = true;
  bool strength = true; ///< it has parameters of strength, which a weak zone can lower
};

/// Of the law that the values name; none where it cannot be made.
std::optional<LawUses> law_uses(const Values& values, const Catalogue& catalogue);

/// Changes the defaults of keys that the law cannot use: no averaging, no patch.
/// @return notes for the user, one line each
std::vector<std::string> fit_defaults(Keys& keys, const LawUses& uses, const CaseFile& given, const Values& values);

/// Refuses given keys that the law cannot use.
void check_uses(const LawUses& uses, const CaseFile& given, const Values& values, const Catalogue& catalogue,
                std::vector<Finding>& errors);

/// Removes the keys that the law cannot use from the table.
void leave_out_useless(Keys& keys, const LawUses& uses);

} // namespace riedel
