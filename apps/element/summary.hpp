/// What an element test leaves in summary.json.
#pragma once

#include "materials/element/curve.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// The keys that follow from the curve.
nlohmann::ordered_json element_summary(const ElementCurve& curve);

} // namespace riedel
