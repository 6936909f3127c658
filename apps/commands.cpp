#include "apps/commands.hpp"

#include "apps/biaxial_keys.hpp"
#include "apps/catalogue.hpp"
#include "apps/key_tables.hpp"

namespace riedel {

namespace {

std::string biaxial_keys_help() { return keys_help(biaxial_keys(full_catalogue(), paper_model)); }

Options check_options() {
  Options options = case_options();
  options.push_back({"schema", "", "print a JSON Schema of the case, for editors"});
  options.push_back({"reference", "", "print the reference of all keys as Markdown"});
  return options;
}

} // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"biaxial", "[CASE.toml] [options]",
       "Plane strain compression of a sand specimen; the paper's case when none is given.", 1,
       run_options("results/biaxial"), biaxial, biaxial_keys_help},
      {"check", "[CASE.toml] [options]",
       "Checks a case, tells all errors at once, or prints it with every key in force.", 1, check_options(), check,
       biaxial_keys_help},
      {"list",
       "[schemes|materials|searches|averagers|plugins]",
       "What can be named in a case, with parameters and units.",
       1,
       {},
       list},
  };
  return all;
}

} // namespace riedel
