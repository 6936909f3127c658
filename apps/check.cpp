#include "apps/biaxial_keys.hpp"
#include "apps/biaxial_sense.hpp"
#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/element_keys.hpp"
#include "apps/key_tables.hpp"
#include "apps/memory_needed.hpp"
#include "apps/memory_there.hpp"
#include "apps/messages.hpp"
#include "apps/outlook.hpp"
#include "core/io/case_text.hpp"

#include <iostream>

namespace riedel {

namespace {

/// Of what a run would be refused for, or warn of, when it begins.
void warn_of_run(const CaseFile& given, const Values& values, const Catalogue& catalogue) {
  for (const Finding& doubt : time_step_doubts(values, expected_work_of(values, catalogue)))
    print_warning(given.lines({doubt}));
  const double need = memory_needed(values, catalogue).of_case();
  const MemoryThere there = memory_there();
  if (need > there.bytes)
    print_warning("a run needs about " + bytes_text(need) + " of memory, and here " + there.by + " " +
                  bytes_text(there.bytes));
}

} // namespace

/// `riedel check`: all errors at once, or the case with every key in force and, as comments, what a run of it will
/// take. What it prints is a case itself. A case that names a test is one of `riedel element`.
int check(const Arguments& arguments) {
  const CaseFile given = arguments.case_file().without("compare"); // of a study, the case that it varies
  const Catalogue catalogue = inventory(given).catalogue;
  if (arguments.has("reference")) {
    std::cout << input_reference(catalogue);
    return 0;
  }
  const auto test = test_of(given);
  if (arguments.has("schema")) {
    std::cout << (test ? element_schema(catalogue, *test) : biaxial_schema(catalogue));
    return 0;
  }
  const CheckedCase checked = test ? element_case(given, catalogue) : biaxial_case(given, catalogue);
  for (const std::string& note : checked.notes) print_note(note);
  for (const std::string& warning : checked.warnings) print_warning(warning);
  if (!test) warn_of_run(given, checked.values, catalogue);
  std::cout << "# ok\n"
            << case_text(checked.keys, checked.values)
            << (test ? element_outlook : biaxial_outlook)(checked.values, catalogue, arguments.threads());
  return 0;
}

} // namespace riedel
