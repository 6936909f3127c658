#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Options of the schemes whose domains deform with their points.
inline const Keys& domain_keys() {
  static const Keys keys{{"domain_limit", 0.0, "-", at_least(0),
                          "cpdi, cpdi2: half diagonals of domains are limited to this many cells; 0: no limit"}};
  return keys;
}

} // namespace riedel
