#include "core/case/case_help.hpp"

#include "core/base/error.hpp"
#include "core/case/key_tables.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// Leaves out the options of other schemes if the case names a scheme.
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

std::string whose(const CaseFile& given, const Keys& keys) {
  const auto scheme = given.peek_text("scheme");
  const Values usual(keys);
  return "with the law " + given.peek_text("material.model").value_or(usual.text("material.model")) +
         (scheme ? " and the scheme " + *scheme : ", and the options of all schemes");
}

} // namespace

void refuse_unknown_names(const CaseFile& given, const Keys& keys) {
  for (const Finding& error : given.check(keys).errors)
    for (const char* name : {"scheme", "material.model", "test"})
      if (error.keys.front() == name) throw InputError(given.lines({error}));
}

std::string case_help(const CaseFile& given, const Keys& keys, const Catalogue& catalogue) {
  refuse_unknown_names(given, keys);
  return keys_help(keys_of_scheme(keys, given, catalogue), whose(given, keys));
}

} // namespace riedel
