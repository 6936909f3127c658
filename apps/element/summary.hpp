/// What an element test writes to summary.json.
#pragma once

#include "materials/element/curve.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// The entries that follow from the curve.
nlohmann::ordered_json element_summary(const ElementCurve& curve);

} // namespace riedel
