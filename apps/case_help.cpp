#include "apps/case_help.hpp"

#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/element/keys.hpp"
#include "apps/kinds.hpp"
#include "core/base/error.hpp"
#include "core/case/case_help.hpp"
#include "core/case/key_tables.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::string help_of(const RunKind& kind, const CaseFile& given) {
  return kind.cases.help(given, load_catalogue(given).catalogue);
}

std::string list_of_tests() {
  std::string text = "Tests, with their own keys\n";
  for (const std::string& test : element_tests()) {
    Keys keys = element_keys(full_catalogue(), test, paper_model);
    std::erase_if(
        keys, [](const Key& key) { return !key.name.starts_with("loading.") && !key.name.starts_with("initial."); });
    std::erase_if(keys, [](const Key& key) { return key.doc.starts_with("mpm: "); });
    text += "\n  " + test + "\n" + parameters_help(keys);
  }
  return text + "\n'riedel element TEST --help' shows all keys of a test, those of its law included.\n";
}

} // namespace

std::string biaxial_help(const Arguments& arguments) {
  return help_of(run_kind("biaxial"), arguments.case_file().without("compare"));
}

std::string element_help(const Arguments& arguments) {
  if (arguments.words.empty())
    return list_of_tests() + "\nExamples\n"
                             "  riedel element triaxial --vary specimen.void_ratio=0.6,0.75,0.9\n"
                             "  riedel element shear --set loading.normal_stress=\"50 kPa\" --out results/shear50\n"
                             "  riedel element path mine.toml\n";
  const std::string& test = arguments.words.front();
  refuse_unknown_names("element test", {test}, element_tests());
  CaseFile given = arguments.case_file(1);
  given.override_with("test=" + test, "riedel element:");
  return help_of(run_kind("element"), given);
}

std::string check_help(const Arguments& arguments) {
  const CaseFile given = arguments.case_file().without("compare");
  return help_of(kind_of(given), given);
}

std::string umat_check_help(const Arguments& arguments) {
  const CaseFile given = arguments.case_file(1);
  refuse_unknown_names(given, umat_check_keys());
  return R"(The UMAT is called through the law "umat", with parameters and state as a case would give them; check.stress and
check.strain are the initial stress, in Pa, and the strain increment (11, 22, 33, 12, 13, 23; engineering shear). The
exit code is 3 if the stress or a declared state depends on the frame, if the UMAT does nothing, or if it fails.
CASE.toml may be the case of a run: only its keys of the law are used.

Example
  riedel umat-check build/mine.so --set material.parameters=[1e8,0.3] --set check.stress=[0,0,0,0,0,0]

)" + keys_help(umat_check_keys(), "with the law umat");
}

} // namespace riedel
