#include "apps/biaxial/keys.hpp"

#include "apps/built_in.hpp"
#include "core/case/interpolation_keys.hpp"
#include "core/case/step_keys.hpp"
#include "core/io/with_vtk.hpp"

#include <algorithm>

namespace riedel {

namespace {

const Bounds any{};
using Reals = std::vector<double>;
using Integers = std::vector<std::int64_t>;

Keys problem_keys(const Catalogue& catalogue) {
  return {
      {"scheme", "gimp", "", any, "interpolation between points and grid", catalogue.in_2d.schemes.names()},
      {"specimen.width", 0.040, "m", more_than(0), "width b0"},
      {"specimen.height", 0.140, "m", more_than(0), "height h0"},
      {"specimen.void_ratio", 0.55, "-", more_than(0), "initial void ratio e0"},
      {"specimen.points_per_cell", std::int64_t{1}, "-", between(1, 10), "material points per cell and direction"},
      {"specimen.rotation", 0.0, "deg", between(-90, 90),
       "angle of the whole test in the grid, anticlockwise; needs platens of rigid points"},
      {"specimen.depth_cells", std::int64_t{1}, "-", between(1, 1000),
       "in three dimensions: cells over the depth, each as deep as wide"},
      {"imperfection.void_ratio", 0.90, "-", more_than(0), "initial void ratio of the loose patch"},
      {"imperfection.size", Reals{5e-3, 5e-3}, "m", at_least(0),
       "width and height of the loose or weak patch; 0: no patch"},
      {"imperfection.centre", Reals{0.0625, 0.5}, "-", between(0, 1),
       "centre of the patch as fractions of width and height"},
      {"imperfection.factor", 1.0, "-", more_than(0),
       "ratio of the strength in the patch to that of the rest: cohesion and tangents of friction angles; 1: the same"},
      {"imperfection.deviation", 0.0, "-", at_least(0),
       "standard deviation of a random field of void ratios about specimen.void_ratio; 0: none"},
      {"imperfection.correlation_length", 5e-3, "m", more_than(0), "correlation length of that field"},
      {"imperfection.seed", std::int64_t{1}, "-", at_least(0), "seed of that field"},
      {"grid.cells", Integers{24, 84}, "-", between(1, 100000), "cells over the width and the height of the specimen"},
      {"grid.dimensions", std::int64_t{2}, "-", between(2, 3),
       "2: plane strain; 3: a slab of the specimen between smooth walls, which keep it in plane strain"},
      {"loading.speed", 0.1, "m/s", more_than(0), "speed v of the upper platen"},
      {"loading.ramp_time", 5e-3, "s", at_least(0), "time over which the speed rises smoothly from zero"},
      {"loading.final_strain", 0.06, "-", within(0, 1), "vertical strain u/h0 at which the test ends"},
      {"loading.confining_pressure", 50e3, "Pa", more_than(0), "lateral pressure p"},
      {"loading.gravity", 9.81, "m/s2", at_least(0), "gravity g"},
      {"loading.platen",
       "moving_grid",
       "",
       any,
       "upper platen: the grid follows it, or rigid points above the specimen press on a grid at rest",
       {"moving_grid", "rigid_points"}},
      {"loading.lateral",
       "virtual_stress",
       "",
       any,
       "lateral pressure: stress in excess of p (exact on any deformed edge), or forces on a layer of points",
       {"virtual_stress", "points"}},
  };
}

Keys averaging_keys(const Catalogue& catalogue) {
  return {
      {"nonlocal.length", 1.5e-3, "m", at_least(0), "characteristic length l_c; 0: local"},
      {"nonlocal.variable", "rate_norm", "", any, "scalar of the law that is averaged"},
      {.name = "nonlocal.search",
       .default_value = catalogue.in_2d.searches.names().front(),
       .unit = "",
       .bounds = any,
       .doc = "search for neighbours",
       .choices = catalogue.in_2d.searches.names(),
       .left_out = catalogue.in_2d.searches.left_out()},
      {"nonlocal.averager", "gauss", "", any, "method of averaging", catalogue.in_2d.averagers.names()},
      plugin_key("nonlocal", "the search or the averager"),
  };
}

Keys output_keys() {
  return {
      {"output.every_strain", 0.0005, "-", within(0, 1), "vertical strain between rows of history.csv"},
      {"output.frames_every_strain", 0.005, "-", within(0, 1), "vertical strain between frames for ParaView"},
      key_for_vtk("output.vtk", "write points.pvd and domains.pvd"),
      key_for_vtk("output.plots", "write pictures (PNG)"),
      {"output.band_void_ratio", 0.70, "-", more_than(0), "minimum void ratio of a point in the shear band"},
  };
}

/// A law knows which of its scalars can be averaged.
void restrict_variable(Keys& keys, const Materials::Entry& law) {
  const auto variables = law.make(Values(law.description.parameters))->nonlocal_variables();
  if (variables.empty()) return;
  Key& key = *std::ranges::find(keys, "nonlocal.variable", &Key::name);
  key.choices = variables;
  if (std::ranges::find(variables, std::get<std::string>(key.default_value)) == variables.end())
    key.default_value = variables.front();
}

} // namespace

Keys biaxial_keys(const Catalogue& catalogue, std::string_view model) {
  Keys keys = problem_keys(catalogue);
  append_material(keys, catalogue, model, paper_model);
  append(keys, interpolation_keys(catalogue));
  append(keys, averaging_keys(catalogue));
  append(keys, step_keys(catalogue));
  append(keys, output_keys());
  if (catalogue.materials.known(model)) restrict_variable(keys, catalogue.materials.find(model));
  return keys;
}

} // namespace riedel
