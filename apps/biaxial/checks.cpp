#include "apps/biaxial/edge_balance.hpp"
#include "apps/biaxial/expected_work.hpp"
#include "apps/biaxial/geometry.hpp"
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/random_field_check.hpp"
#include "core/case/dimension_check.hpp"
#include "core/case/interpolation_keys.hpp"
#include "core/case/step_keys.hpp"
#include "core/case/transfer_keys.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riedel {

namespace {

void check_imperfection(const BiaxialCase& v, std::vector<Finding>& errors) {
  constexpr double round_off = 1e-9;
  const auto &size = v.imperfection.size, &centre = v.imperfection.centre;
  const std::vector<std::string> edges{"specimen.width", "specimen.height"};
  for (std::size_t axis = 0; axis < edges.size(); ++axis) {
    const double length = v.keys.number(edges[axis]), middle = centre[axis] * length, half = 0.5 * size[axis];
    if (middle - half >= -round_off * length && middle + half <= (1.0 + round_off) * length) continue;
    errors.push_back({{"imperfection.centre", "imperfection.size", edges[axis]},
                      "the patch reaches from " + rounded(middle - half) + " m to " + rounded(middle + half) +
                          " m, out of the specimen's [0, " + exact_text(length) + "] m (" + edges[axis] + ")"});
  }
}

void check_number_of_points(const BiaxialCase& v, std::vector<Finding>& errors) {
  const double points = expected_points(v);
  const double maximum = std::numeric_limits<Index>::max();
  if (points > maximum)
    errors.push_back({{"grid.cells", "specimen.points_per_cell", "specimen.depth_cells"},
                      exact_text(points) + " points are too many; allowed: at most " + exact_text(maximum)});
}

void check_depth(const BiaxialCase& v, std::vector<Finding>& errors) {
  const std::int64_t depth = v.specimen.depth_cells;
  if (v.grid.dimensions == 2 && depth != 1)
    errors.push_back({{"specimen.depth_cells", "grid.dimensions"},
                      std::to_string(depth) + " means nothing in two dimensions; leave it out, or take "
                                              "grid.dimensions = 3"});
}

/// Rigid points allow a rotated specimen; conditions on rows of nodes and forces on columns of points do not.
void check_rotation(const BiaxialCase& v, std::vector<Finding>& errors) {
  const std::string turned = "specimen.rotation";
  if (v.specimen.rotation == 0.0) return;
  const auto refuse = [&](const char* key, const std::string& what, const std::string& wanted) {
    errors.push_back(
        {{key, turned},
         what + " does not go with a specimen rotated by " + exact_text(v.specimen.rotation) + " deg; take " + wanted});
  };
  if (v.loading.platen != BiaxialCase::Platen::rigid_points)
    refuse("loading.platen", "\"moving_grid\"", "\"rigid_points\"");
  if (v.loading.lateral != BiaxialCase::Lateral::virtual_stress)
    refuse("loading.lateral", "\"points\"", "\"virtual_stress\"");
  if (v.grid.dimensions == 3) refuse("grid.dimensions", "3", "2");
}

/// A sum over points h apart acts like the integral only while h is not much above l_c.
void check_spacing(const BiaxialCase& v, std::vector<Finding>& warnings) {
  constexpr double max_ratio = 1.12; // 1.1; 24 × 84 cells of the paper (1.111 for l_c = 1.5 mm) are fine enough
  const double l_c = v.nonlocal.length;
  const auto& cells = v.grid.cells;
  const double per_direction = static_cast<double>(v.specimen.points_per_cell);
  const double h =
      std::max(v.specimen.width / static_cast<double>(cells[0]), v.specimen.height / static_cast<double>(cells[1])) /
      per_direction;
  if (l_c == 0.0 || h <= max_ratio * l_c) return;
  warnings.push_back({{"nonlocal.length", "grid.cells", "specimen.points_per_cell"},
                      "the points are " + rounded(h) + " m apart, more than 1.1 l_c = " + rounded(1.1 * l_c) +
                          " m: the average acts like one of a shorter length; use more cells or a larger length"});
}

/// Points at the sides distribute their share of the pressure by hats; the stress behind them must balance it on every
/// node. Evaluates the forces of a specimen, for a valid law and scheme.
void check_sides(const BiaxialCase& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  constexpr double maximum = 0.01; // share of the pressure
  if (v.loading.lateral != BiaxialCase::Lateral::points || !errors.empty()) return;
  const double imbalance = imbalance_at_start(v, catalogue);
  if (imbalance <= maximum) return;
  const std::string& scheme = v.scheme;
  const std::string per_cell = std::to_string(v.specimen.points_per_cell);
  std::string others;
  BiaxialCase with = v;
  for (const std::string& name : catalogue.in_2d.schemes.names()) {
    with.scheme = name;
    if (imbalance_at_start(with, catalogue) <= maximum) others += ", " + name;
  }
  errors.push_back({{"loading.lateral", "scheme", "specimen.points_per_cell"},
                    "\"points\" starts out of balance under the scheme \"" + scheme + "\" with " + per_cell +
                        " per cell and direction: nodes at the sides retain " + rounded(100.0 * imbalance) +
                        " % of the pressure's force; take \"virtual_stress\", exact for every scheme" +
                        (others.empty() ? "" : ", or one of the schemes " + others.substr(2))});
}

} // namespace

Diagnostics check_biaxial(const BiaxialCase& values, const Catalogue& catalogue) {
  Diagnostics found;
  check_limits_of_void_ratio(values.keys, found.errors);
  const std::string pressure = "loading.confining_pressure";
  for (const char* key : {"specimen.void_ratio", "imperfection.void_ratio"})
    check_void_ratio(values.keys, key, {values.loading.confining_pressure, pressure, "confining pressure"},
                     found.errors);
  check_imperfection(values, found.errors);
  check_step(values.keys, catalogue, found.errors);
  check_interpolation(values.keys, catalogue, found.errors);
  check_transfer(values.keys, catalogue, found);
  check_depth(values, found.errors);
  check_offered(values.keys, catalogue, values.grid.dimensions, found.errors);
  check_number_of_points(values, found.errors);
  check_rotation(values, found.errors);
  check_random_field(values, catalogue, found);
  check_sides(values, catalogue, found.errors);
  check_spacing(values, found.warnings);
  return found;
}

} // namespace riedel
