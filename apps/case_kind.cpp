#include "apps/case_kind.hpp"

#include "apps/biaxial/keys.hpp"
#include "apps/element/keys.hpp"
#include "apps/element/path_keys.hpp"

#include <algorithm>

namespace riedel {

namespace {

bool is_unknown(const Finding& finding) { return finding.text.starts_with("unknown key"); }

/// The unknown keys that another command has.
std::vector<std::string> taken_by(const Keys& keys, const std::vector<Finding>& errors) {
  std::vector<std::string> names;
  for (const Finding& error : errors)
    if (is_unknown(error) && std::ranges::find(keys, error.keys.front(), &Key::name) != keys.end())
      names.push_back(error.keys.front());
  return names;
}

/// Replaces the findings about keys that another command takes by a single one.
void tell_other(std::vector<Finding>& errors, const std::vector<std::string>& names, const std::string& command,
                const std::string& other) {
  std::erase_if(errors, [&](const Finding& error) {
    return is_unknown(error) && std::ranges::find(names, error.keys.front()) != names.end();
  });
  const std::string more = names.size() == 1 ? "" : " (nor are " + std::to_string(names.size() - 1) + " more)";
  errors.insert(errors.begin(), {names, "is no key of 'riedel " + command + "'" + more + "; 'riedel " + other +
                                            "' takes " + (names.size() == 1 ? "it" : "them")});
}

Keys keys_of_test(const CaseFile& given, const std::string& test, const Catalogue& catalogue) {
  Keys keys = element_keys(catalogue, test, model_of(given));
  if (test == "path") append(keys, path_keys(given));
  return keys;
}

} // namespace

void tell_where_keys_are_listed(std::vector<Finding>& errors, const std::string& command) {
  for (Finding& error : errors)
    if (error.text == "unknown key") error.text += "; 'riedel " + command + " --help' lists the known ones";
}

void leave_keys_of_runs(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const auto test = test_of(given);
  const std::vector<std::string> known =
      taken_by(test ? keys_of_test(given, *test, catalogue) : biaxial_keys(catalogue, model_of(given)), errors);
  std::erase_if(errors, [&](const Finding& error) {
    return is_unknown(error) &&
           (error.keys.front() == "test" || std::ranges::find(known, error.keys.front()) != known.end());
  });
}

void explain_unknown_biaxial_keys(const CaseFile& given, const Catalogue& catalogue, std::vector<Finding>& errors) {
  std::vector<std::string> names;
  std::string best;
  for (const std::string& test : element_tests()) { // the one that knows most of the keys
    const auto taken = taken_by(keys_of_test(given, test, catalogue), errors);
    if (taken.size() > names.size() || (!taken.empty() && test == test_of(given))) names = taken, best = test;
    if (test == test_of(given)) break;
  }
  if (!names.empty())
    tell_other(errors, names, "biaxial",
               "element " + best + (test_of(given) ? "" : "', or a case that says 'test = \"" + best + "\""));
  tell_where_keys_are_listed(errors, "biaxial");
}

void explain_unknown_element_keys(const CaseFile& given, const std::string& test, const Catalogue& catalogue,
                                  std::vector<Finding>& errors) {
  const auto names = taken_by(biaxial_keys(catalogue, model_of(given)), errors);
  if (!names.empty()) tell_other(errors, names, "element " + test, "biaxial");
  tell_where_keys_are_listed(errors, "element " + test);
}

} // namespace riedel
