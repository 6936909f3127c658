/// The pictures of a biaxial test.
#pragma once

#include "apps/biaxial/record.hpp"

namespace riedel {

/// Writes history.png and .svg, and a picture of each of the drawn fields that the law knows; returns their names.
/// @param section the specimen at the end, in the plane
std::vector<std::string> draw_biaxial(const std::vector<BiaxialRow>& rows, const Frame& section,
                                      const BiaxialCase& values, const std::filesystem::path& folder);

} // namespace riedel
