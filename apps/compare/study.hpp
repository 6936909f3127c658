/// Which runs a command and its case file ask for.
#pragma once

#include "apps/command_line.hpp"
#include "core/case/vary.hpp"

namespace riedel {

/// One case, and what is varied of it.
struct Study {
  std::string title;
  CaseFile given; ///< what does not change
  std::vector<Variation> variations;
};

/// From the case file's section [compare] (title, schemes, vary) and from --schemes and --vary. The command line has
/// the last word, key by key. "all" stands for all schemes. @throws InputError for what is wrong or empty in either
Study study_of(const Arguments& arguments);

} // namespace riedel
