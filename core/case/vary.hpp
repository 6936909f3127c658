/// One case with several values of some keys.
#pragma once

#include "core/case/case_file.hpp"

namespace riedel {

/// A key and one of its values, as TOML or as a bare word.
using Setting = std::pair<std::string, std::string>;

/// A case with some keys set.
struct Variant {
  CaseFile given;
  std::string name;                   ///< of its folder, such as "void_ratio=0.6"; empty when nothing is varied
  std::string label;                  ///< for a legend, such as "void_ratio = 0.6"
  std::vector<Setting> settings = {}; ///< the settings, in the order of the options
};

/// A key with the values that it takes in turn.
struct Variation {
  std::string key;
  std::vector<std::string> values;
};

/// "KEY=A,B,C" split into its parts; commas in brackets or quotes do not separate values.
/// @throws InputError that shows the expected form, or which value is empty or given twice, or which bracket is open
Variation variation_of(const std::string& wish);

/// Several such options. @throws InputError also for a key that is varied twice
std::vector<Variation> variations_of(const std::vector<std::string>& wishes);

/// All combinations of the values of all keys; the first key changes last. Keys are shown by their last word if that is
/// unique. Names are unique and fit a file system, if necessary by eight letters derived from the label.
/// @throws InputError for more than 1000 runs
std::vector<Variant> variants_of(const CaseFile& given, const std::vector<Variation>& variations);

/// Maps a case, written with every key in force, to the name of its run.
struct NamedCase {
  std::string name, text;
};

/// @throws InputError for two runs of the same case, such as with 1.5mm and 0.0015
void refuse_same_cases(const std::vector<NamedCase>& cases);

} // namespace riedel
