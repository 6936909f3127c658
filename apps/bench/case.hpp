/// What `riedel bench` runs: a block of sand, well inside its grid, that is sheared and compressed slowly.
#pragma once

#include "core/interface/catalogue.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// One row of the table.
struct BenchCase {
  std::string scheme = "gimp", material = "gudehus_bauer", order = "musl", transfer = "flip";
  int dimension = 2;
  Index points = 10'000; ///< requested; rounded to whole cells
  Index per_cell = 2;    ///< points per cell along each direction
  int threads = 1;
  double length = 0.0; ///< l_c [m]; 0: local
  std::string averager = "gauss", search = "cgal_kd_tree";
  int filter = 0;                ///< steps from one filtering of the stresses to the next; 0: never
  std::string stencils = "auto"; ///< kept for a step, evaluated in blocks, or what the library chooses
};

namespace bench_block {
constexpr double cell = 0.04 / 24;       ///< h of the paper's case [m]
constexpr double pressure = 100e3;       ///< stress −p I at the start, balanced by the confining pressure [Pa]
constexpr double void_ratio = 0.6;       ///< if the law has one [-]
constexpr double strain_per_step = 1e-6; ///< ‖D‖ Δt at the start [-]
constexpr double flip = 0.98;
constexpr double filter_rate = 1e4; ///< about the default of the biaxial test [1/s]
} // namespace bench_block

const std::vector<std::string>& step_orders();    ///< musl, usl, usf
const std::vector<std::string>& stencil_memory(); ///< auto, kept, blocks

/// Cells of the block along each axis: nearly a square (cube), with about the requested number of points.
template <int Dim>
Counts<Dim> block_cells(Index points, Index per_cell);

/// Throws InputError when the case names something that the catalogue does not have.
template <int Dim>
Simulation<Dim> make_block(const BenchCase& wanted, const Catalogue& catalogue);

/// Resets the stress, state and velocity of every point at its present position: the block neither comes to rest nor
/// fails, however long it is measured.
template <int Dim>
void set_in_motion(Simulation<Dim>& simulation);

} // namespace riedel
