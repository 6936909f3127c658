/// Sub-commands and their options.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/case/case_file.hpp"
#include "core/io/version.hpp"

#include <map>
#include <optional>
#include <span>

namespace riedel {

/// What the user typed after the sub-command's name.
struct Arguments {
  std::string command;            ///< the whole command line, such as "riedel biaxial --threads 1"
  std::vector<std::string> words; ///< those that belong to no option: the case file for most
  std::map<std::string, std::vector<std::string>, std::less<>> options; ///< given ones; a switch has no values

  [[nodiscard]] bool has(std::string_view option) const { return options.find(option) != options.end(); }
  [[nodiscard]] std::optional<std::string> text(std::string_view option) const; ///< the last one given
  /// The words of a list: "a,b", or of an option given more than once. @throws InputError for an empty word
  [[nodiscard]] std::vector<std::string> list(std::string_view option, const std::vector<std::string>& otherwise) const;
  /// A list of names. @throws InputError for an unknown one
  [[nodiscard]] std::vector<std::string> names(std::string_view option, const std::vector<std::string>& otherwise,
                                               const std::vector<std::string>& known) const;
  [[nodiscard]] std::filesystem::path out(const std::filesystem::path& otherwise) const; ///< --out
  [[nodiscard]] bool force() const { return has("force"); }
  /// @throws InputError for anything but an integer in [minimum, maximum]
  [[nodiscard]] int integer(std::string_view option, int otherwise, int minimum, int maximum) const;
  /// --threads N, exactly, or A-B; without it OMP_NUM_THREADS, exactly, or from one to all that this process may use.
  /// @throws InputError when it is neither a positive number nor such a range
  [[nodiscard]] ThreadRange threads() const;
  /// The case file (the word at `position`, else the defaults) with every --set on it.
  [[nodiscard]] CaseFile case_file(std::size_t position = 0) const;
  [[nodiscard]] CaseFile with_settings(CaseFile file) const; ///< with every --set on it
};

struct Option {
  std::string name;
  std::string value; ///< placeholder of its value in the help; empty: a switch; with a comma: a list
  std::string doc;
  bool repeated = false;                 ///< may be given more than once; lists always may
  std::vector<std::string> choices = {}; ///< allowed words of its value or list; empty: any
};
using Options = std::vector<Option>;
Options case_options(); ///< --set
Option plugin_option(); ///< --plugin
/// --set, --out, --threads, --force
/// @param folder that holds the results when there is no --out
Options run_options(const std::string& folder);

struct Command {
  std::string name;
  std::string usage; ///< what follows the name
  std::string summary;
  std::size_t max_words; ///< that belong to no option
  Options options;
  int (*run)(const Arguments&); ///< returns the exit code
  /// Text at the end of `--help`; it may depend on the words and settings beside it.
  std::string (*more_help)(const Arguments&) = nullptr;
  std::vector<std::string> first_words = {}; ///< what the first word can be, for completion; empty: as usage says
};

/// @param place of the list, such as "--schemes"
/// @throws InputError for the first unknown name, with its position in the list, the nearest known name, and all names
void refuse_unknown_names(const std::string& place, const std::vector<std::string>& given,
                          const std::vector<std::string>& known);

/// The short form of an option, -o for --out; 0 for none.
char letter_of(std::string_view option);

/// `--help`, `-h` and a last word `help` are the option "help"; "version" likewise.
/// @param others commands that may have the options which this one does not have
/// @throws InputError with a hint when the words do not fit the command
Arguments parse(const Command& command, const std::vector<std::string>& words, std::span<const Command> others = {});

} // namespace riedel
