#include "apps/command_help.hpp"

#include "apps/element/keys.hpp"
#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 2, width), ' ');
  return text;
}

std::string line(const Option& option) {
  const char letter = letter_of(option.name);
  const std::string names = (letter == 0 ? "" : std::string{'-', letter, ',', ' '}) + "--" + option.name;
  return "  " + padded(names + (option.value.empty() ? "" : " " + option.value), 22) + option.doc + "\n";
}

/// Names the command for a case file that was given in place of a command.
std::string taker_of(const std::string& path) {
  const auto test = test_of(CaseFile::read(path));
  return "'" + path + "' is a file, not a command; 'riedel " + (test ? "element " + *test : "biaxial") + " " + path +
         "' runs a case";
}

} // namespace

const Command& find_command(std::span<const Command> commands, std::string_view name) {
  std::vector<std::string> names;
  for (const Command& command : commands) {
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  const std::string given(name);
  if (given.ends_with(".toml") && std::filesystem::is_regular_file(given)) throw InputError(taker_of(given));
  std::string hint = did_you_mean(name, names);
  if (const auto& tests = element_tests(); std::ranges::find(tests, given) != tests.end())
    hint = " (did you mean 'riedel element " + given + "'?)";
  std::string known;
  for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
  throw InputError("unknown command '" + given + "'" + hint + "; known: " + known);
}

std::string help(const Command& command, const Arguments& arguments) {
  std::string text = "riedel " + command.name + " " + command.usage + "\n\n" + command.summary + "\n\nOptions\n";
  for (const Option& option : command.options) text += line(option);
  text += line({"help", "", "print this"}) + line({"version", "", "print the version"});
  return command.more_help == nullptr ? text : text + "\n" + command.more_help(arguments);
}

std::string help(std::span<const Command> commands) {
  std::string text = "riedel: the material point method for shear localisation in sand\n\nCommands\n";
  for (const Command& command : commands) text += "  " + padded(command.name, 12) + command.summary + "\n";
  text += "\nExamples\n";
  for (const Meaning& example : example_lines()) text += "  " + padded(example.name, 58) + example.text + "\n";
  text += R"(
'riedel COMMAND --help' tells more of each command, 'riedel list NAME' of a scheme, a law or a key; 'riedel --version'
prints the version, 'riedel --man' the manual page. The paper is Krzyżanowski, Wójcik and Tejchman (2020).

Exit codes
)";
  for (const Meaning& code : exit_codes()) text += "  " + padded(code.name, 10) + code.text + "\n";
  text += "\nEnvironment\n";
  for (const Meaning& variable : environment_variables())
    text += "  " + padded(variable.name, 24) + variable.text + "\n";
  return text;
}

const std::vector<Meaning>& exit_codes() {
  static const std::vector<Meaning> all{
      {"0", "done"},
      {"1", "an internal error: a bug"},
      {"2", "the input is wrong: a case, a key, an option or a file"},
      {"3", "the run failed: unstable, points lost, or results that cannot be written"},
      {"4", "a plug-in is missing, or cannot be used"},
      {"130, 143", "interrupted by Ctrl-C or by a request to end (SIGTERM); what was written so far can be read"}};
  return all;
}

const std::vector<Meaning>& environment_variables() {
  static const std::vector<Meaning> all{
      {"OMP_NUM_THREADS", "number of threads if --threads is not given"},
      {"RIEDEL_PLUGIN_PATH", "folders, separated by colons, from which all plug-ins (*.so) are loaded"},
      {"RIEDEL_PLUGIN_TIMEOUT", "seconds that loading a plug-in or a UMAT may take; default: 10"},
      {"NO_COLOR", "if set to any value, messages have no colour"},
      {"TMPDIR", "folder for the copies of a UMAT that the threads use; default: /tmp"}};
  return all;
}

const std::vector<Meaning>& result_files() {
  static const std::vector<Meaning> all{
      {"case.toml", "every key in force: running it again gives the same bits"},
      {"history.csv", "of riedel biaxial: a row per output, with angle, force and energies against u/h0"},
      {"element.csv", "of riedel element: a row per output, with strains, stresses, void ratio and angle"},
      {"summary.json", "results of the whole run; docs/howto/read_results.md explains each of them"},
      {"points.pvd, domains.pvd",
       "all fields in time, for ParaView; the files of the frames are in points and domains"},
      {"*.png", "history, void ratio and shear strain; the curves of an element test"},
      {"results.csv, report.html",
       "of riedel compare and riedel reproduce: a row for each run, and a page with all results"}};
  return all;
}

const std::vector<Meaning>& example_lines() {
  static const std::vector<Meaning> all{
      {"riedel biaxial", "the paper's case; results go to results/biaxial"},
      {"riedel biaxial --set scheme=cpdi --out results/cpdi", "one key changed"},
      {"riedel biaxial --set material.model=mohr_coulomb --help", "the keys, with those of that law"},
      {"riedel list mohr_coulomb", "one law, scheme, search or averager, or one key"},
      {"riedel check > case.toml", "a case file with every key, to edit"},
      {"riedel biaxial case.toml --out results/mine", "run that case"},
      {"riedel element triaxial --set specimen.void_ratio=0.7", "an element test at one point"},
      {"riedel compare --schemes gimp,cpdi", "the same case under two schemes, with a report"}};
  return all;
}

} // namespace riedel
