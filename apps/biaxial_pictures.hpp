/// The pictures of a biaxial test.
#pragma once

#include "apps/biaxial_run.hpp"

namespace riedel {

/// Writes history.png and .svg, void_ratio.png and shear_strain.png; returns their names.
std::vector<std::string> draw_biaxial(const BiaxialRun& run, const Values& values, const std::filesystem::path& folder);

} // namespace riedel
