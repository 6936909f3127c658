/// The pictures of a biaxial test.
#pragma once

#include "apps/biaxial_run.hpp"

namespace riedel {

/// Writes history.png and .svg, shear_strain.png and, for a law that knows it, void_ratio.png; returns their names.
/// @param section the specimen at the end, in the plane
std::vector<std::string> draw_biaxial(const std::vector<BiaxialRow>& rows, const Frame& section, const Values& values,
                                      const std::filesystem::path& folder);

} // namespace riedel
