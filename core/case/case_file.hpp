/// A case: a TOML file, overridden by settings of the command line, and the check of both against a table of keys.
#pragma once

#include "core/case/raw_entry.hpp"

#include <filesystem>
#include <optional>
#include <unordered_set>

namespace riedel {

/// A message about the values of some keys; the first key gives the place.
struct Finding {
  std::vector<std::string> keys;
  std::string text; ///< without the place
};

/// Values in force, with the default for every wrong value, and the errors.
struct CheckedValues {
  Values values;
  std::vector<Finding> errors;
};

class CaseFile {
public:
  /// An empty case: every key keeps its default.
  static CaseFile empty() { return {}; }
  /// @throws InputError: missing, unreadable, or not TOML (with line and column)
  static CaseFile read(const std::filesystem::path& path);
  /// A text as a case file. @param called its name in messages @throws InputError
  static CaseFile from_text(std::string_view text, const std::string& called);

  /// One `--set key.path=value`; the value is TOML, otherwise a plain text. The last setting of a key wins.
  /// @param source its origin in messages @throws InputError if it is not such a setting
  void override_with(std::string_view assignment, const std::string& source = "--set");

  /// The text given for a key, before validation: needed because the law's name decides which parameters there are.
  [[nodiscard]] std::optional<std::string> peek_text(std::string_view key) const;

  /// The texts of a list; none if the key is not given. @throws InputError, with the place, if it is another value
  [[nodiscard]] std::optional<std::vector<std::string>> peek_texts(std::string_view key) const;

  /// The keys given in a section, in order.
  [[nodiscard]] std::vector<std::string> names_in(std::string_view section) const;
  /// The same case without them.
  [[nodiscard]] CaseFile without(std::string_view section) const;

  /// Number of tables in an array: [[stage]] tables have the keys "stage.1.…", "stage.2.…", which may also be written
  /// as [stage.1] or --set stage.1.…; tables after a gap are not counted.
  [[nodiscard]] int count(std::string_view list) const;

  /// Where a key was given: "case.toml:12:9: specimen.width", "--set specimen.width" or "specimen.width (default)".
  [[nodiscard]] std::string place(std::string_view key) const;

  /// Checks everything given against the keys.
  [[nodiscard]] CheckedValues check(const Keys& keys) const;
  /// The same, but throws one InputError with a line per error.
  [[nodiscard]] Values validate(const Keys& keys) const;

  /// One line per finding, each beginning with its place.
  [[nodiscard]] std::string lines(const std::vector<Finding>& findings) const;

private:
  [[nodiscard]] const RawEntry* find(std::string_view key) const;

  std::vector<RawEntry> given_;           ///< in the order of the file, then of the settings
  std::unordered_set<std::string> names_; ///< all names ever given
};

} // namespace riedel
