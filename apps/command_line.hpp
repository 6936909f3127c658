/// Sub-commands and their options.
#pragma once

#include "core/base/thread_choice.hpp"
#include "core/case/case_file.hpp"
#include "core/io/version.hpp"

#include <map>
#include <optional>
#include <span>

namespace riedel {

/// What the user typed behind the sub-command's name.
struct Arguments {
  std::string command;            ///< all of it, such as "riedel biaxial --threads 1", to be typed again
  std::vector<std::string> words; ///< those that belong to no option: the case file for most
  std::map<std::string, std::vector<std::string>, std::less<>> options; ///< given ones; a switch has no values

  [[nodiscard]] bool has(std::string_view option) const { return options.find(option) != options.end(); }
  [[nodiscard]] std::optional<std::string> text(std::string_view option) const; ///< the last one given
  /// The words of a list: "a,b", or the option more than once. @throws InputError for an empty word
  [[nodiscard]] std::vector<std::string> list(std::string_view option, const std::vector<std::string>& otherwise) const;
  /// A list of names. @throws InputError for one that is not known
  [[nodiscard]] std::vector<std::string> names(std::string_view option, const std::vector<std::string>& otherwise,
                                               const std::vector<std::string>& known) const;
  [[nodiscard]] std::filesystem::path out(const std::filesystem::path& otherwise) const; ///< --out
  [[nodiscard]] bool force() const { return has("force"); }
  /// @throws InputError for what is no integer in [least, most]
  [[nodiscard]] int integer(std::string_view option, int otherwise, int minimum, int maximum) const;
  /// --threads N, exactly, or A-B; without it OMP_NUM_THREADS, exactly, or from one to all that this process may use.
  /// @throws InputError when it is no positive number and no such range
  [[nodiscard]] ThreadRange threads() const;
  /// The case file (the word at `position`, else the defaults) with every --set on it.
  [[nodiscard]] CaseFile case_file(std::size_t position = 0) const;
  [[nodiscard]] CaseFile with_settings(CaseFile file) const; ///< with every --set on it
};

struct Option {
  std::string name;
  std::string value; ///< what stands for its value in the help; empty: a switch; with a comma: a list
  std::string doc;
  bool repeated = false;                 ///< may be given more than once; lists always may
  std::vector<std::string> choices = {}; ///< the words that its value, or its list, is made of; empty: any
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
  /// What `--help` adds at its end; it may depend on the words and settings beside it.
  std::string (*more_help)(const Arguments&) = nullptr;
  std::vector<std::string> first_words = {}; ///< what the first word can be, for completion; empty: as usage says
};

/// @param place of the list, such as "--schemes"   @throws InputError for the first name that is not known: with its
/// place in a list of several, the nearest known one, and all
void refuse_unknown_names(const std::string& place, const std::vector<std::string>& given,
                          const std::vector<std::string>& known);

/// The letter that stands for an option as well, -o for --out; 0 for none.
char letter_of(std::string_view option);

/// `--help`, `-h` and a last word `help` are the option "help"; "version" likewise.
/// @param others that may have an option which this one has not
/// @throws InputError with a hint when the words do not fit the command
Arguments parse(const Command& command, const std::vector<std::string>& words, std::span<const Command> others = {});

} // namespace riedel
