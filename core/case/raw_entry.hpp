/// A case as written, before it is checked against a table of keys.
#pragma once

#include "core/base/parameters.hpp"

namespace riedel {

/// std::monostate stands for what no key accepts, such as a date or a list in a list.
using Scalar = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct RawEntry {
  enum class Kind { single, list, empty_section };

  std::string name;  ///< dotted path of the key
  std::string place; ///< "case.toml:12:9: specimen.width" or "--set specimen.width": every message begins with it
  std::string text;  ///< the value as TOML, for messages
  std::vector<Scalar> items; ///< one for a single value
  Kind kind = Kind::single;
};

/// What a key accepts, in words: "a number > 0 in m, or a text with a unit (m, cm, mm, um)".
std::string wanted(const Key& key);

/// @throws InputError that says what was given and what is allowed, without the place
Value convert(const RawEntry& given, const Key& key);

} // namespace riedel
