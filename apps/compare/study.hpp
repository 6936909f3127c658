/// The runs that a command and its case file request.
#pragma once

#include "apps/command_line.hpp"
#include "core/case/vary.hpp"

namespace riedel {

/// A case and its variations.
struct Study {
  std::string title;
  CaseFile given; ///< the keys that do not vary
  std::vector<Variation> variations;
};

/// From the case file's section [compare] (title, schemes, vary) and from --schemes and --vary. The command line takes
/// precedence, key by key. "all" stands for all schemes. @throws InputError for anything wrong or empty in either
Study study_of(const Arguments& arguments);

} // namespace riedel
