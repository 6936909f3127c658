#include "apps/built_in.hpp"
#include "apps/case_help.hpp"
#include "apps/commands.hpp"
#include "apps/kinds.hpp"
#include "apps/reference.hpp"
#include "core/case/case_text.hpp"
#include "core/io/messages.hpp"
#include "core/run/memory_there.hpp"

#include <iostream>

namespace riedel {

namespace {

/// Warns of what a run would be refused for, or would warn of, when it begins.
void warn_of_run(const CaseKind& kind, const CaseFile& given, const Values& values, const Catalogue& catalogue) {
  for (const Finding& doubt : kind.doubts(values, catalogue)) print_warning(given.lines({doubt}));
  const double need = kind.expect(values, catalogue).memory;
  const MemoryThere there = memory_there();
  if (need > there.bytes)
    print_warning("a run needs about " + bytes_text(need) + " of memory, but " + there.by + " " +
                  bytes_text(there.bytes));
}

} // namespace

/// `riedel check`: reports all errors at once, or prints the case with every key in force and, as comments, the cost of
/// a run. The output is itself a case. A case that names a test is one of `riedel element`.
namespace {

int check(const Arguments& arguments) {
  const CaseFile given = arguments.case_file().without("compare"); // of a study, the case that it varies
  const Catalogue catalogue = load_catalogue(given).catalogue;
  if (arguments.has("reference")) {
    std::cout << input_reference(catalogue);
    return 0;
  }
  const CaseKind& kind = kind_of(given).cases;
  if (arguments.has("schema")) {
    std::cout << kind.schema(given, catalogue);
    return 0;
  }
  const CheckedCase checked = kind.check(given, catalogue);
  for (const std::string& note : checked.notes) print_note(note);
  for (const std::string& warning : checked.warnings) print_warning(warning);
  warn_of_run(kind, given, checked.values, catalogue);
  std::cout << "# ok\n"
            << case_text(checked.keys, checked.values) << kind.outlook(checked.values, catalogue, arguments.threads());
  return 0;
}

Options check_options() {
  Options options = case_options();
  options.push_back({"schema", "", "print a JSON Schema of the case, for editors"});
  options.push_back({"reference", "", "print the reference of all keys as Markdown"});
  return options;
}

} // namespace

Command check_command() {
  return {.name = "check",
          .usage = "[CASE.toml] [options]",
          .summary = "Checks a case: reports all errors at once, or prints the case with every key in force.",
          .max_words = 1,
          .options = check_options(),
          .run = check,
          .more_help = check_help};
}

} // namespace riedel
