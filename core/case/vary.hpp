/// One case under several values of some keys.
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
  std::vector<Setting> settings = {}; ///< what was set, in the order of the wishes
};

/// A key with the values that it takes in turn.
struct Variation {
  std::string key;
  std::vector<std::string> values;
};

/// "KEY=A,B,C" taken apart; a comma in brackets or quotes parts nothing.
/// @throws InputError that says what a wish looks like, which value is empty or stands twice, which bracket is open
Variation variation_of(const std::string& wish);

/// Several wishes. @throws InputError for a key that is varied twice, too
std::vector<Variation> variations_of(const std::vector<std::string>& wishes);

/// All values of all keys, crossed; the first key changes last. Keys are called by their last word where that tells
/// them apart. No two names are the same, and each fits a file system; eight letters that stand for the label see to
/// both. @throws InputError for more than 1000 runs
std::vector<Variant> variants_of(const CaseFile& given, const std::vector<Variation>& variations);

/// A case by its run's name, as it is written with every key in force.
struct NamedCase {
  std::string name, text;
};

/// @throws InputError for two runs of one case, such as of 1.5mm and 0.0015
void refuse_same_cases(const std::vector<NamedCase>& cases);

} // namespace riedel
