#include "apps/case_help.hpp"

#include "apps/biaxial_keys.hpp"
#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/element_keys.hpp"
#include "apps/key_tables.hpp"
#include "apps/path_keys.hpp"
#include "core/base/error.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// A name that is wrong has no keys to show.
void refuse_unknown_names(const CaseFile& given, const Keys& keys) {
  for (const Finding& error : given.check(keys).errors)
    for (const char* name : {"scheme", "material.model", "test"})
      if (error.keys.front() == name) throw InputError(given.lines({error}));
}

/// Without the options of other schemes, when the case names one.
Keys keys_of_scheme(Keys keys, const CaseFile& given, const Catalogue& catalogue) {
  const auto scheme = given.peek_text("scheme");
  if (!scheme || !catalogue.in_2d.schemes.known(*scheme)) return keys;
  const Keys& options = catalogue.in_2d.schemes.find(*scheme).description.parameters;
  std::erase_if(keys, [&](const Key& key) {
    return key.name.starts_with("interpolation.") && key.name != "interpolation.plugin" &&
           std::ranges::find(options, key.name.substr(key.name.find('.') + 1), &Key::name) == options.end();
  });
  return keys;
}

std::string whose(const CaseFile& given) {
  const auto scheme = given.peek_text("scheme");
  return "with the law " + model_of(given) +
         (scheme ? " and the scheme " + *scheme : ", and the options of all schemes");
}

std::string help_of_biaxial(const CaseFile& given) {
  const Catalogue catalogue = inventory(given).catalogue;
  const Keys keys = biaxial_keys(catalogue, model_of(given));
  refuse_unknown_names(given, keys);
  return keys_help(keys_of_scheme(keys, given, catalogue), whose(given));
}

std::string help_of_element(const CaseFile& given, const std::string& test) {
  const Catalogue catalogue = inventory(given).catalogue;
  const Keys keys = element_keys(catalogue, test, model_of(given));
  refuse_unknown_names(given, keys);
  std::string text = keys_help(keys_of_scheme(keys, given, catalogue), whose(given));
  if (test == "path")
    text += "\nOf each [[stage]]; docs/howto/element_paths.md tells how they work together\n" +
            parameters_help(stage_keys("")) + "\nOf each [[stage.leg]]\n" + parameters_help(leg_keys(""));
  return text;
}

std::string list_of_tests() {
  std::string text = "Tests, with the keys that are their own\n";
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
  return help_of_biaxial(arguments.case_file().without("compare"));
}

std::string element_help(const Arguments& arguments) {
  if (arguments.words.empty())
    return list_of_tests() + "\nExamples\n"
                             "  riedel element triaxial --vary specimen.void_ratio=0.6,0.75,0.9\n"
                             "  riedel element shear --set loading.normal_stress=\"50 kPa\" --out results/shear50\n"
                             "  riedel element path mine.toml\n";
  const std::string& test = arguments.words.front();
  refuse_unknown_names("element test", {test}, element_tests());
  return help_of_element(arguments.case_file(1), test);
}

std::string check_help(const Arguments& arguments) {
  const CaseFile given = arguments.case_file().without("compare");
  const auto test = test_of(given);
  if (!test) return help_of_biaxial(given);
  refuse_unknown_names(given.place("test") + ":", {*test}, element_tests());
  return help_of_element(given, *test);
}

std::string umat_check_help(const Arguments& arguments) {
  const CaseFile given = arguments.case_file(1);
  refuse_unknown_names(given, umat_check_keys());
  return R"(The UMAT is called through the law "umat", with parameters and state as a case would give them; check.stress and
check.strain are the start, in Pa, and the increment (11, 22, 33, 12, 13, 23; engineering shear). Exit code 3 if its
stress or a declared state depends on the frame, if it does nothing, or if it fails. CASE.toml may be the case of a run:
what it says of anything but the law is left out.

Example
  riedel umat-check build/mine.so --set material.parameters=[1e8,0.3] --set check.stress=[0,0,0,0,0,0]

)" + keys_help(umat_check_keys(), "with the law umat");
}

} // namespace riedel
