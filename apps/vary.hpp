/// One case under several values of some keys.
#pragma once

#include "core/io/case_file.hpp"

namespace riedel {

/// A case with some keys set.
struct Variant {
  CaseFile given;
  std::string name;  ///< of its folder, such as "void_ratio=0.6"; empty when nothing is varied
  std::string label; ///< for a legend, such as "void_ratio = 0.6"
};

/// @param wishes each "KEY=A,B,C" as TOML values (a list of lists for keys that are lists); several are crossed
/// @throws InputError that says what a wish looks like
std::vector<Variant> variants_of(const CaseFile& given, const std::vector<std::string>& wishes);

} // namespace riedel
