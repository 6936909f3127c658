/// Properties of a scheme for tests: its traits, and the width of its functions.
#pragma once

#include "support/problems.hpp"

namespace riedel::test {

inline SchemeTraits traits(const std::string& name) { return scheme<2>(name)->traits(); }

/// Names of the registered schemes with a trait, for parameterised suites.
template <class Promise>
std::vector<std::string> schemes_that(const Promise& promise) {
  std::vector<std::string> names = scheme_names();
  std::erase_if(names, [&](const std::string& name) { return !promise(traits(name)); });
  return names;
}

/// Evaluated at the point, with gradients that extend beyond its cell.
inline bool reaches_without_domain(const SchemeTraits& scheme) {
  return scheme.domain == PointDomain::none && scheme.continuous_gradients;
}

/// Mean of Σ_i N_ip (x_i − x_p)²/h² along an axis over places in a cell, two points to a cell [-]: 1/6 for hats, 1/4
/// and 1/3 for quadratic and cubic splines. The wider the functions, the more motion is exchanged between points.
inline double width_of(const std::string& name) {
  constexpr Index places = 16;
  const auto shape = scheme<2>(name);
  Grid<2> grid = grid_of<2>({4, 4}, 1.0, 4);
  Points<2> points;
  points.resize(places, 0);
  for (Index p = 0; p < places; ++p) {
    points.position[0][p] = 2.0 + (p + 0.5) / places;
    points.position[1][p] = 2.3;
    for (int a = 0; a < 2; ++a) points.half_size[a][p] = 0.25;
  }
  Stencils<2> stencils;
  stencils.resize(places, shape->max_nodes());
  Columns node_data{0};
  evaluate_anew(*shape, grid, points, node_data, stencils);
  double sum = 0.0;
  for (Index p = 0; p < places; ++p) {
    const StencilGroup<2>& group = stencils.group_of(p);
    const int lane = p % pack_size;
    for (int e = 0; e < group.count; ++e)
      sum += group.value_of(e, lane) *
             square(grid.position(grid.index(group.node_of(e, lane)))[0] - points.position[0][p]);
  }
  return sum / places;
}

/// Wider than what is averaged over a point's domain, and wider than quadratic splines.
inline bool is_wide(const std::string& name) { return width_of(name) > 0.24; }
inline bool is_very_wide(const std::string& name) { return width_of(name) > 0.3; }

} // namespace riedel::test
