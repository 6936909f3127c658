/// TOML as a list of what it gives.
#pragma once

#include "core/base/error.hpp"
#include "core/case/raw_entry.hpp"

namespace riedel {

/// What is no TOML. The text is "called:line:column: not valid TOML: why".
struct TomlError : InputError {
  TomlError(const std::string& text, std::string reason) : InputError(text), why(std::move(reason)) {}
  std::string why;
};

/// Every value of a TOML text with its dotted name and its place, in the order of the text. The tables of an array are
/// numbered from one. A part of a name that is no bare word keeps its quotes, so that "a.b" is not a.b.
/// @param called what messages call the text, such as its path   @throws InputError, TomlError among them
std::vector<RawEntry> read_toml(std::string_view text, const std::string& called);

/// "KEY=VALUE", as the command line gives it: one key and, on one line, a TOML value or else a text as it stands. There
/// is more than one answer when the value is a table.
/// @param source what messages call the place it comes from, such as "--set"   @throws InputError
std::vector<RawEntry> read_assignment(std::string_view assignment, const std::string& source);

} // namespace riedel
