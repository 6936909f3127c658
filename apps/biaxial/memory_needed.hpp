/// The memory that a run of the biaxial test takes, before it begins.
#pragma once

#include "apps/biaxial/case.hpp"
#include "core/case/case_file.hpp"
#include "core/interface/catalogue.hpp"

namespace riedel {

/// Parts of the maximum amount at any time [bytes].
struct MemoryNeeded {
  double program = 0.0; ///< itself, with its libraries
  double points = 0.0, nodes = 0.0, stencils = 0.0;
  double neighbours = 0.0; ///< of the non-local average
  double frames = 0.0;     ///< while one is written
  [[nodiscard]] double of_case() const { return points + nodes + stencils + neighbours + frames; }
  [[nodiscard]] double all() const { return program + of_case(); }
};

/// Within 30 % of measurements (tests/apps/test_memory.cpp), from the case's numbers alone: nothing is allocated.
MemoryNeeded memory_needed(const BiaxialCase& values, const Catalogue& catalogue);

/// Pairs of points of a regular lattice at most `radius` apart, each point with itself and each pair in both orders.
/// @param counts of points along each axis   @param spacing between them [m]   @param radius [m]
double pairs_within(const std::array<double, 3>& counts, const std::array<double, 3>& spacing, double radius);

/// @throws InputError that names the keys if the case needs more memory than there is
void require_memory(const BiaxialCase& values, const Catalogue& catalogue, const CaseFile& file);

} // namespace riedel
