#include "apps/biaxial_keys.hpp"
#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/key_tables.hpp"
#include "apps/messages.hpp"
#include "core/io/case_text.hpp"

#include <iostream>

namespace riedel {

/// `riedel check`: all errors at once, or the case with every key in force. What it prints is a case itself.
int check(const Arguments& arguments) {
  const Catalogue catalogue = full_catalogue();
  if (arguments.has("schema")) {
    std::cout << biaxial_schema(catalogue);
    return 0;
  }
  if (arguments.has("reference")) {
    std::cout << biaxial_reference(catalogue);
    return 0;
  }
  const CheckedCase checked = biaxial_case(arguments.case_file(), catalogue);
  for (const std::string& warning : checked.warnings) print_warning(warning);
  std::cout << "# ok\n" << case_text(checked.keys, checked.values);
  return 0;
}

} // namespace riedel
