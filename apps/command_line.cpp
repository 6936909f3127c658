#include "apps/command_line.hpp"

#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/io/shell_word.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <charconv>
#include <cstdlib>
#include <omp.h>
#include <sstream>

namespace riedel {

namespace {

namespace po = boost::program_options;
using Texts = std::vector<std::string>;

std::string joined(const Texts& words, const std::string& between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}

/// The options of a command, with those that every command has.
Options options_of(const Command& command) {
  Options options = command.options;
  options.push_back({"help", "", ""});
  options.push_back({"version", "", ""});
  return options;
}

po::options_description described(const Options& options) {
  po::options_description description;
  for (const Option& option : options) {
    std::string names = option.name;
    if (const char letter = letter_of(option.name)) (names += ',') += letter;
    if (option.value.empty())
      description.add_options()(names.c_str(), "");
    else
      description.add_options()(names.c_str(), po::value<Texts>()->composing(), "");
  }
  return description;
}

std::string hint(const Command& command) { return "; see 'riedel " + command.name + " --help'"; }

/// Names at most three commands that have this option, for the error of a command that does not have it.
std::string takers_text(std::span<const Command> commands, std::string_view given) {
  std::string names;
  int count = 0;
  for (const Command& command : commands)
    for (const Option& option : command.options)
      if (given == "--" + option.name && ++count <= 3)
        names += (names.empty() ? "'riedel " : ", 'riedel ") + command.name + "'";
  if (names.empty()) return "";
  return "; " + names + (count > 3 ? " and others take it" : count > 1 ? " take it" : " takes it");
}

std::string unknown_option_text(const Command& command, std::span<const Command> others, const std::string& given) {
  Texts names;
  for (const Option& option : options_of(command)) names.push_back("--" + option.name);
  const std::string takers = takers_text(others, given);
  return "unknown option " + given + (takers.empty() ? did_you_mean(given, names) : takers) + hint(command);
}

std::string wrong_value_text(const Command& command, const po::error_with_option_name& error) {
  const std::string given = error.get_option_name();
  for (const Option& option : options_of(command))
    if (given == "--" + option.name || given == std::string{'-', letter_of(option.name)})
      return "--" + option.name +
             (option.value.empty() ? " takes no value" : " needs a value: --" + option.name + " " + option.value) +
             hint(command);
  return error.what() + hint(command);
}

/// Short options cannot be combined: -out is not "-o ut" but a long option with one dash missing.
void refuse_single_dashes(const Command& command, std::span<const Command> others, const Texts& words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    const bool letters = word.size() > 2 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
    if (letters) throw InputError(unknown_option_text(command, others, word.substr(0, word.find('='))));
  }
}

/// Whether the last word asks for help, and is no file or folder.
bool asks_for_help(const Texts& words) {
  return !words.empty() && words.back() == "help" && !std::filesystem::exists("help");
}

/// What the user typed, with quotes where a shell needs them.
std::string typed(const Command& command, const Texts& words) {
  std::string line = "riedel " + command.name;
  for (const std::string& word : words) line += " " + shell_word(word);
  return line;
}

constexpr int max_threads_allowed = 1024;

std::optional<int> whole(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

} // namespace

std::optional<std::string> Arguments::text(std::string_view option) const {
  const auto found = options.find(option);
  return found == options.end() || found->second.empty() ? std::nullopt : std::optional(found->second.back());
}

std::filesystem::path Arguments::out(const std::filesystem::path& otherwise) const {
  const std::optional<std::string> given = text("out");
  return given ? std::filesystem::path(*given) : otherwise;
}

int Arguments::integer(std::string_view option, int otherwise, int minimum, int maximum) const {
  const std::optional<std::string> given = text(option);
  if (!given) return otherwise;
  const std::optional<int> number = whole(*given);
  if (!number || *number < minimum || *number > maximum)
    throw InputError("--" + std::string(option) + " " + *given + ": allowed: an integer in [" +
                     std::to_string(minimum) + ", " + std::to_string(maximum) + "]");
  return *number;
}

ThreadRange Arguments::threads() const {
  const std::optional<std::string> given = text("threads");
  if (!given) {
    const char* wished = std::getenv("OMP_NUM_THREADS"); // OpenMP has read and checked its value
    const bool wish = wished != nullptr && *wished != '\0';
    const int maximum = std::clamp(wish ? omp_get_max_threads() : omp_get_num_procs(), 1, max_threads_allowed);
    return {wish ? maximum : 1, maximum};
  }
  const std::size_t dash = given->find('-', 1);
  const std::optional<int> minimum = whole(given->substr(0, dash)),
                           maximum = dash == std::string::npos ? minimum : whole(given->substr(dash + 1));
  if (!minimum || !maximum || *minimum < 1 || *maximum < *minimum || *maximum > max_threads_allowed)
    throw InputError("--threads " + *given + ": allowed: an integer in [1, " + std::to_string(max_threads_allowed) +
                     "], or a range of them, such as 1-4, from which the program chooses while it runs");
  return {*minimum, *maximum};
}

Texts Arguments::list(std::string_view option, const Texts& otherwise) const {
  const auto found = options.find(option);
  if (found == options.end()) return otherwise;
  Texts entries;
  for (const std::string& given : found->second) {
    std::istringstream stream(given + ",");
    for (std::string word; std::getline(stream, word, ',');) {
      if (word.empty()) throw InputError("--" + std::string(option) + " " + given + ": an entry of the list is empty");
      if (std::ranges::find(entries, word) == entries.end()) entries.push_back(word);
    }
  }
  return entries;
}

Texts Arguments::names(std::string_view option, const Texts& otherwise, const Texts& known) const {
  Texts given = list(option, otherwise);
  refuse_unknown_names("--" + std::string(option), given, known);
  return given;
}

CaseFile Arguments::case_file(std::size_t position) const {
  const bool named = words.size() > position;
  if (named && words[position].find('=') != std::string::npos && !std::filesystem::exists(words[position]))
    throw InputError(words[position] + ": there is no such case file (did you mean '--set " + words[position] + "'?)");
  return with_settings(named ? CaseFile::read(words[position]) : CaseFile::empty());
}

CaseFile Arguments::with_settings(CaseFile file) const {
  if (const auto found = options.find("set"); found != options.end())
    for (const std::string& setting : found->second) file.override_with(setting);
  return file;
}

Options case_options() {
  return {{"set", "KEY=VALUE", "set a key of the case, such as --set grid.cells=[16,56]; may be repeated", true}};
}

Option plugin_option() {
  return {"plugin", "FILE.so",
          "load a plug-in in addition to those in the folders of RIEDEL_PLUGIN_PATH; may be repeated", true};
}

Options run_options(const std::string& folder) {
  Options options = case_options();
  options.push_back({"out", "DIR", "folder for the results; default: " + folder});
  options.push_back(
      {"threads", "N", "or A-B: the program chooses while it runs; default: 1 to all; results do not depend on it"});
  options.push_back({"force", "", "overwrite the results in the folder"});
  return options;
}

void refuse_unknown_names(const std::string& place, const Texts& given, const Texts& known) {
  const auto unknown = std::ranges::find_if(
      given, [&](const std::string& name) { return std::ranges::find(known, name) == known.end(); });
  if (unknown == given.end()) return;
  std::string which = ": unknown";
  if (given.size() > 1)
    which = ": number " + std::to_string(unknown - given.begin() + 1) + " of the list, " + *unknown + ", is unknown";
  throw InputError(place + " " + joined(given, ",") + which + did_you_mean(*unknown, known) +
                   "; known: " + joined(known, ", "));
}

char letter_of(std::string_view option) {
  return option == "help" || option == "version" || option == "out" ? option.front() : '\0';
}

Arguments parse(const Command& command, const std::vector<std::string>& words, std::span<const Command> others) {
  refuse_single_dashes(command, others, words);
  const po::options_description known = described(options_of(command));
  Arguments arguments{.command = typed(command, words), .words = {}, .options = {}};
  try {
    namespace style = po::command_line_style;
    const auto parsed =
        po::command_line_parser(words).options(known).style(style::unix_style & ~style::allow_guessing).run();
    arguments.words = po::collect_unrecognized(parsed.options, po::include_positional);
    for (const auto& option : parsed.options) {
      if (option.position_key >= 0) continue;
      Texts& values = arguments.options[option.string_key];
      values.insert(values.end(), option.value.begin(), option.value.end());
    }
  } catch (const po::unknown_option& error) {
    throw InputError(unknown_option_text(command, others, error.get_option_name()));
  } catch (const po::error_with_option_name& error) {
    throw InputError(wrong_value_text(command, error));
  } catch (const po::error& error) { throw InputError(error.what() + hint(command)); }
  if (asks_for_help(arguments.words)) {
    arguments.words.pop_back();
    arguments.options["help"];
  }
  if (!arguments.has("help") && arguments.words.size() > command.max_words)
    throw InputError("'" + arguments.words[command.max_words] + "' is one word too many; expected: riedel " +
                     command.name + " " + command.usage);
  return arguments;
}

} // namespace riedel
