/// TOML as a list of its values.
#pragma once

#include "core/base/error.hpp"
#include "core/case/raw_entry.hpp"

namespace riedel {

/// Thrown for text that is not TOML. The message is "called:line:column: not valid TOML: why".
struct TomlError : InputError {
  TomlError(const std::string& text, std::string reason) : InputError(text), why(std::move(reason)) {}
  std::string why;
};

/// All values of a TOML text with their dotted names and places, in the order of the text. The tables of an array are
/// numbered from one. A part of a name that is not a bare word keeps its quotes, so that "a.b" differs from a.b.
/// @param called the text's name in messages, such as its path @throws InputError, including TomlError
std::vector<RawEntry> read_toml(std::string_view text, const std::string& called);

/// "KEY=VALUE" from the command line: one key and, on one line, a TOML value or otherwise a plain text. There is more
/// than one answer if the value is a table.
/// @param source its origin in messages, such as "--set" @throws InputError
std::vector<RawEntry> read_assignment(std::string_view assignment, const std::string& source);

} // namespace riedel
