/// The boundary of apps/plugins/absorbing.cpp under incident waves, and the page that shows it.
#include "apps/riedel.hpp"
#include "plugin/plugins.hpp"
#include "support/problems.hpp"

#include <cstdio>
#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::HasSubstr;

constexpr double h = 0.1, density = 2000.0, G = 8e7, M = 2.4e8; // Poisson's ratio 1/4: M = 3 G
const double c_p = std::sqrt(M / density), c_s = std::sqrt(G / density);

NodeBox<2> column_end(const Grid<2>& grid, const ShapeFunction<2>& shape, Behind behind) {
  const Index margin = shape.margin() + 2, end = grid.nodes[1] - 1 - margin;
  NodeBox<2> place{.first = {margin, 0}, .last = {margin + 1, margin}, .axis = 1, .behind = behind};
  if (behind == Behind::upper) place = {{margin, end}, {margin + 1, grid.nodes[1] - 1}, 1, behind};
  return place;
}

/// The remaining energy of a pulse that starts in the middle of a column, after it has reached both ends.
/// @param axis along which the points of the pulse move: 1 compression, 0 shear
double energy_left(const Catalogue& catalogue, int axis, bool absorbs) {
  constexpr Index cells = 60;
  Model<2> model = model_with<2>("gimp");
  const Index margin = model.scheme->margin() + 2;
  State<2> state = elastic_state<2>({1, cells}, h, 2, margin, [](const Vec<2>&) { return true; },
                                    {{"youngs_modulus", 2.5 * G}, {"poissons_ratio", 0.25}, {"density", density}});
  Points<2>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    const double s = (points.position[1][p] - 0.5 * cells * h) / (0.3 * cells * h);
    points.velocity[axis][p] = std::abs(s) < 0.5 ? 1e-3 * square(std::cos(std::numbers::pi * s)) : 0.0;
  }
  const Counts<2> end{state.grid.nodes[0] - 1, state.grid.nodes[1] - 1}; // a wave in one dimension
  model.conditions.push_back(
      prescribe<2>({.name = "plane", .last = end, .axis = 1 - axis, .velocity = [](double) { return 0.0; }}));
  for (const Behind behind : {Behind::lower, Behind::upper})
    if (absorbs)
      model.conditions.push_back(make(catalogue.in_2d.boundaries, "absorbing",
                                      {{"density", density}, {"pressure_wave", c_p}, {"shear_wave", c_s}}, "end",
                                      column_end(state.grid, *model.scheme, behind)));
  model.transfer = transfer<2>("flip", {{"flip", 1.0}});
  Simulation<2> simulation(std::move(model), std::move(state));
  const double start = simulation.energies().kinetic, duration = cells * h / (axis == 1 ? c_p : c_s);
  while (simulation.state().time < duration) simulation.step();
  const Energies now = simulation.energies();
  std::printf("axis %d, absorbs %d: left %.5f, dissipated %.4f, unaccounted %.1e of the energy at the start\n", axis,
              absorbs, (now.kinetic + now.internal) / start, now.dissipated / start, now.unaccounted / start);
  EXPECT_NEAR(now.external, -now.dissipated, 1e-12 * start) << "dashpots at rest";
  EXPECT_LT(std::abs(now.unaccounted), 0.01 * start);
  return (now.kinetic + now.internal) / start;
}

TEST(AbsorbingPlugin, LetsCompressionAndShearWavesLeave) {
  const Catalogue all = catalogue_with(example("absorbing"));
  for (const int axis : {1, 0}) {
    EXPECT_LT(energy_left(all, axis, true), 0.01);
    EXPECT_GT(energy_left(all, axis, false), 0.95) << "what a free end sends back";
  }
}

TEST(AbsorbingPlugin, IsListedWithItsParameters) {
  const TemporaryFolder folder;
  const Outcome listed = run(folder, {"list", "absorbing", "--plugin", example("absorbing")});
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("Lysmer & Kuhlemeyer (1969)"));
  EXPECT_THAT(listed.out, HasSubstr("speed c_s of its shear waves"));
  EXPECT_THAT(run(folder, {"list", "plugins", "--plugin", example("absorbing")}).out,
              HasSubstr("boundary condition absorbing"));
}

TEST(HowtoAddABoundary, ShowsThePlugInAsItStands) {
  EXPECT_THAT(file_content(SOURCE_DIR "/docs/howto/add_a_boundary.md"),
              HasSubstr("```cpp\n" + file_content(SOURCE_DIR "/apps/plugins/absorbing.cpp") + "```"));
}

} // namespace
} // namespace riedel::test
