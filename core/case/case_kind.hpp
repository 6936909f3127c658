/// A kind of case, such as the biaxial test, as run by a sub-command. Everything that handles cases of any kind (check,
/// help, schema, studies) uses this interface.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// The expected cost of running a case, as far as it is known in advance.
struct ExpectedRun {
  double work = 0.0;   ///< points times steps times relative cost of each [-]
  double end = 0.0;    ///< strain at which it ends; 0: unknown [-]
  double memory = 0.0; ///< in addition to the program itself [bytes]; 0: almost none
};

struct CaseKind {
  std::string name; ///< of the sub-command that runs it
  /// Whether a case file is of this kind.
  bool (*holds)(const CaseFile& given) = nullptr;
  /// The words of the sub-command before the case file, such as "element triaxial".
  std::vector<std::string> (*words)(const CaseFile& given) = nullptr;
  /// Every key that the case may have, including those of its law.
  Keys (*keys)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  /// @throws InputError with one line per error; PluginError
  CheckedCase (*check)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  ExpectedRun (*expect)(const Values& values, const Catalogue& catalogue) = nullptr;
  /// The warnings that a run would print at its start.
  std::vector<Finding> (*doubts)(const Values& values, const Catalogue& catalogue) = nullptr;
  /// What will run, as comments after the case in force.
  std::string (*outlook)(const Values& values, const Catalogue& catalogue, ThreadRange threads) = nullptr;
  /// The keys as a table for a terminal. @throws InputError for an unknown law, scheme or test
  std::string (*help)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  /// JSON Schema (draft 7). @throws InputError for an unknown test
  std::string (*schema)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
};

} // namespace riedel
