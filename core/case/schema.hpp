/// JSON Schema (draft 7) of cases, for editors.
#pragma once

#include "core/interface/catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// The schema of a whole case. The parameters allowed in [material] follow from its model.
nlohmann::ordered_json case_schema(const std::string& title, const Keys& keys, const Catalogue& catalogue);

/// The schema of a table with exactly these keys, whose names have no section.
nlohmann::ordered_json object_schema(const Keys& keys);

} // namespace riedel
