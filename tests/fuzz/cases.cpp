// Case files and the settings of the command line.
#include "apps/biaxial/keys.hpp"
#include "apps/element/path_keys.hpp"
#include "apps/fake_catalogue.hpp"
#include "core/case/case_text.hpp"
#include "core/case/vary.hpp"
#include "core/io/units.hpp"
#include "fuzz/support.hpp"
#include "fuzz/targets.hpp"
#include "materials/umat/states.hpp"

#include <cmath>
#include <set>
#include <sstream>

namespace riedel::fuzz {

namespace {

/// The keys that a case may have: those of the biaxial test, and those of as many stages as it gives.
Keys keys_of(const CaseFile& given) {
  static const Catalogue catalogue = fake_catalogue();
  Keys keys = biaxial_keys(catalogue, model_of(given));
  append(keys, path_keys(given));
  return keys;
}

/// A case that passes its keys reads the same when it is written out.
void check(const CaseFile& given) {
  const Keys keys = keys_of(given);
  const Values values = given.validate(keys);
  const Values again = CaseFile::from_text(case_text(keys, values), "again").validate(keys);
  require(again.all() == values.all(), "a case that is written out is another one");
}

std::vector<std::string> lines_of(std::string_view input) {
  std::istringstream stream{std::string(input)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

} // namespace

void case_file(std::string_view input) {
  may_refuse([&] { check(CaseFile::from_text(input, "case.toml")); });
}

void assignment(std::string_view input) {
  may_refuse([&] {
    CaseFile given = CaseFile::empty();
    given.override_with(input);
    check(given);
  });
}

void quantity(std::string_view input) {
  for (const char* unit : {"m", "Pa", "m/s", "deg", "kg/m3", "-", "1/s"})
    may_refuse([&] { require(std::isfinite(read_quantity(input, unit)), "a quantity is not finite"); });
}

void umat_states(std::string_view input) {
  may_refuse([&] {
    const UmatStates states(std::string(input), {}, 1e3);
    require(states.size() <= UmatStates::maximum, "more states than a UMAT can have");
    require(states.start().size() == states.size() + 6, "a start of another length");
  });
}

void variations(std::string_view input) {
  may_refuse([&] {
    std::set<std::string> names;
    for (const Variant& variant : variants_of(CaseFile::empty(), variations_of(lines_of(input)))) {
      constexpr std::size_t longest = 255;
      require(variant.name.size() <= longest, "a name is too long for a folder");
      require(variant.name.find('/') == std::string::npos, "a name is a path");
      require(names.insert(variant.name).second, "two runs have one name");
    }
  });
}

} // namespace riedel::fuzz
