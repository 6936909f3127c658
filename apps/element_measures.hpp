/// What a path can prescribe of a point, or watch in it: strains and stresses by the names of element.csv.
#pragma once

#include "materials/point_driver.hpp"

namespace riedel {

struct Measure {
  std::string name;
  std::string unit; ///< "Pa" of a stress, "-" of a strain, "deg" of an angle
  std::string doc;
  double (*of)(const LawPoint&);
  bool can_be_prescribed = true; ///< or only watched
};

/// Compression positive, lengths over initial lengths.
const std::vector<Measure>& measures();

/// @throws InputError that lists the known ones
const Measure& find_measure(std::string_view name);

/// That the measure becomes `target` at the end of the leg.
Condition condition(const Measure& measure, double target);

} // namespace riedel
