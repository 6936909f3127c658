/// A kind of case, such as the biaxial test: what a sub-command runs. Whatever works with cases of any kind (check,
/// help, schema, studies) goes by this.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/case/checked_case.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// What a run of a case takes, as far as it is known before.
struct ExpectedRun {
  double work = 0.0;   ///< points times steps times what each takes beside the others [-]
  double end = 0.0;    ///< strain at which it ends; 0: not known [-]
  double memory = 0.0; ///< beside the program itself [bytes]; 0: next to none
};

struct CaseKind {
  std::string name; ///< of the sub-command that runs it
  /// Whether a case file is of this kind.
  bool (*holds)(const CaseFile& given) = nullptr;
  /// The words of the sub-command in front of the case file, such as "element triaxial".
  std::vector<std::string> (*words)(const CaseFile& given) = nullptr;
  /// Every key that the case may have, those of its law among them.
  Keys (*keys)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  /// @throws InputError with a line for everything that is wrong; PluginError
  CheckedCase (*check)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  ExpectedRun (*expect)(const Values& values, const Catalogue& catalogue) = nullptr;
  /// What a run would warn of when it begins.
  std::vector<Finding> (*doubts)(const Values& values, const Catalogue& catalogue) = nullptr;
  /// What will run, as comments behind the case in force.
  std::string (*outlook)(const Values& values, const Catalogue& catalogue, ThreadRange threads) = nullptr;
  /// The keys as a table for a terminal. @throws InputError for a law, scheme or test that is not known
  std::string (*help)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
  /// JSON Schema (draft 7). @throws InputError for a test that is not known
  std::string (*schema)(const CaseFile& given, const Catalogue& catalogue) = nullptr;
};

} // namespace riedel
