/// A column of sand between rollers, one cell wide, that a platen compresses, unloads until its grains separate, and
/// compresses again. A point driver of the same law gives the curve; a horizontal column gives the same result.
///
/// Separated points fly freely. With PIC they keep the platen's affine motion, and meet as they separated; under FLIP
/// they rattle, which compacts the sand, so that the second curve lies below that of the point.
#include "materials/element/point_driver.hpp"
#include "support/problems.hpp"

#include <Eigen/LU>
#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

constexpr double cell = 0.01, void_ratio = 0.6, pressure = 1e3;
constexpr Index cells = 4, per_cell = 2, margin = 4;
constexpr double height = cells * cell;

/// Displacement of the platen, downwards and relative to the height: each stage starts and ends at rest.
constexpr std::array<double, 3> stages{0.004, -0.004, 0.004};
constexpr double duration = 0.1; ///< of a stage [s]

double platen_velocity(double time) {
  const auto stage = static_cast<std::size_t>(time / duration);
  if (stage >= stages.size()) return 0.0;
  const double share = time / duration - static_cast<double>(stage);
  return -stages[stage] * height / duration * (1.0 - std::cos(2.0 * std::numbers::pi * share));
}

struct ColumnCase {
  std::string scheme;
  double cohesion; ///< p_t [Pa]
  double flip = 0.0;
};
void PrintTo(const ColumnCase& c, std::ostream* out) { *out << c.scheme << ", " << c.cohesion; }

std::shared_ptr<const Material> sand(double cohesion) {
  return material("gudehus_bauer", {{"cohesion_pressure", cohesion}});
}

/// @param axis along which the column stands
Simulation<2> column(const ColumnCase& of, int axis) {
  const int across = 1 - axis;
  Counts<2> count{};
  count[static_cast<std::size_t>(axis)] = cells;
  count[static_cast<std::size_t>(across)] = 1;
  State<2> state;
  state.grid = grid_of<2>(count, cell, margin);
  Body<2>& body = state.bodies.emplace_back();
  body.name = "column";
  body.material = sand(of.cohesion);
  const std::array<double, 2> values{void_ratio, 0.0};
  fill<2>(body.points, count, cell, per_cell, body.material->density(values), 2, [](const Vec<2>&) { return true; });
  body.points.state.fill(0, void_ratio);
  for (int c = 0; c < 3; ++c) body.points.stress.fill(c, -pressure);

  Model<2> model = model_with<2>(of.scheme);
  const auto still = [](double) { return 0.0; };
  const Counts<2> last{state.grid.nodes[0] - 1, state.grid.nodes[1] - 1};
  const auto from = [&](int a, Index row) { // nodes whose number along `a` is `row` or more
    Counts<2> first{0, 0};
    first[static_cast<std::size_t>(a)] = row;
    return first;
  };
  const auto to = [&](int a, Index row) {
    Counts<2> end = last;
    end[static_cast<std::size_t>(a)] = row;
    return end;
  };
  model.conditions = prescribe_each<2>({{"left", {0, 0}, to(across, margin), across, still},
                                        {"right", from(across, margin + 1), last, across, still},
                                        {"bottom", {0, 0}, to(axis, margin), axis, still},
                                        {"top", from(axis, margin + cells), last, axis, platen_velocity}});
  model.transfer = transfer<2>("flip", {{"flip", of.flip}});
  model.moving_grids.push_back({.axis = axis, .fixed_row = margin, .moving_row = margin + cells, .platen = "top"});
  return {std::move(model), std::move(state)};
}

/// Means over the points at one moment. Compression is positive.
struct Moment {
  double strain = 0.0; ///< of the column, relative to its height at the start
  double axial = 0.0;  ///< [Pa]
};

struct Outcome {
  std::vector<Moment> moments;
  std::array<std::size_t, 3> stage_ends{}; ///< moments at which stages have ended
  double max_gap = 0.0, max_distance = 0;  ///< in void ratio at contact, against that at separation; share of points
  double stress_apart = 0.0;               ///< largest norm of a separated point's stress [Pa]
  double stress_at_rest = 0.0;             ///< largest norm at the end of the second stage [Pa]
  double kinetic = 0.0, balance = 0.0;     ///< maximum energies, over the maximum internal one
  bool finite = true;
};

/// Checks after each step whether a point has lost or regained contact.
class Contacts {
public:
  explicit Contacts(Index points) : gap_(points), parted_at_(points) {}

  void look(const Points<2>& points, Outcome& run) {
    double apart = 0.0;
    for (Index p = 0; p < points.size(); ++p) {
      const auto id = static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)]);
      const double e = points.state[0][p], gap = points.state[1][p];
      if (gap_[id] == 0.0 && gap > 0.0) parted_at_[id] = (1.0 + e) * std::exp(-gap) - 1.0;
      if (gap_[id] > 0.0 && gap == 0.0) run.max_gap = std::max(run.max_gap, std::abs(e - parted_at_[id]) / (1.0 + e));
      gap_[id] = gap;
      if (gap == 0.0) continue;
      apart += 1.0 / points.size();
      for (int c = 0; c < 6; ++c) run.stress_apart = std::max(run.stress_apart, std::abs(points.stress[c][p]));
    }
    run.max_distance = std::max(run.max_distance, apart);
  }

private:
  std::vector<double> gap_, parted_at_;
};

Outcome carry_out(const ColumnCase& of, int axis) {
  Simulation<2> simulation = column(of, axis);
  const Points<2>& points = simulation.state().bodies[0].points;
  Outcome run;
  Contacts contacts(points.size());
  double internal = 0.0;
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    while (simulation.state().time < (static_cast<double>(stage) + 1.0) * duration) {
      simulation.step();
      contacts.look(points, run);
      Moment now{.strain = 1.0 - simulation.state().grid.cell[axis] / cell};
      for (Index p = 0; p < points.size(); ++p) now.axial -= points.stress[axis][p] / points.size();
      run.moments.push_back(now);
      const Energies energies = simulation.energies();
      run.finite = run.finite && std::isfinite(now.axial) && std::isfinite(energies.kinetic);
      internal = std::max(internal, std::abs(energies.internal));
      run.kinetic = std::max(run.kinetic, energies.kinetic);
      run.balance = std::max(run.balance, std::abs(energies.external - energies.internal - energies.kinetic));
    }
    run.stage_ends[stage] = run.moments.size();
    if (stage == 1)
      for (Index p = 0; p < points.size(); ++p)
        for (int c = 0; c < 6; ++c) run.stress_at_rest = std::max(run.stress_at_rest, std::abs(points.stress[c][p]));
  }
  run.kinetic /= internal;
  run.balance /= internal;
  EXPECT_EQ(simulation.state().report.failures, 0);
  return run;
}

/// The same history at one point.
std::vector<std::vector<Moment>> point_curves(double cohesion) {
  const auto law = sand(cohesion);
  PointDriver driver(*law, {.stress = -pressure * Sym<double>::identity(), .state = {void_ratio, 0.0}},
                     {.largest_strain = 1e-4});
  std::vector<std::vector<Moment>> curves;
  double strain = 0.0;
  for (const double stage : stages) {
    strain += stage;
    std::vector<Moment>& curve = curves.emplace_back();
    const auto stretch = [](int a, double target) {
      return Condition{"stretch", [a](const MaterialPoint& q) { return q.F(a, a); }, target, false};
    };
    const auto shear = [](int i, int j) {
      return Condition{"shear", [i, j](const MaterialPoint& q) { return q.F(i, j); }, 0.0, false};
    };
    const LoadStep leg{.conditions = {stretch(0, 1.0 - strain), stretch(1, 1.0), stretch(2, 1.0), shear(0, 1),
                                      shear(0, 2), shear(1, 2)}};
    EXPECT_TRUE(driver.follow(leg, [&](const MaterialPoint& q) {
      curve.push_back({1.0 - q.F(0, 0), -q.stress.m[0]});
      return true;
    }));
  }
  return curves;
}

double at(const std::vector<Moment>& curve, double strain) {
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i].strain < strain) ++i;
  const double t = (strain - curve[i - 1].strain) / (curve[i].strain - curve[i - 1].strain);
  return std::lerp(curve[i - 1].axial, curve[i].axial, t);
}

/// Largest difference in a stage of compression, over the stress at its end.
double farthest(const Outcome& run, std::size_t stage, const std::vector<Moment>& curve) {
  double maximum = 0.0;
  for (std::size_t i = stage ? run.stage_ends[stage - 1] : 0; i < run.stage_ends[stage]; ++i)
    maximum = std::max(maximum, std::abs(run.moments[i].axial - at(curve, run.moments[i].strain)));
  return maximum / curve.back().axial;
}

class UnloadedColumn : public testing::TestWithParam<ColumnCase> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
};

void expect_sound(const Outcome& run) {
  EXPECT_TRUE(run.finite);
  EXPECT_EQ(run.stress_apart, 0.0);
  EXPECT_LT(run.kinetic, 1e-3);
  EXPECT_LT(run.balance, 0.01);
}

TEST_P(UnloadedColumn, PartsAndFollowsThePointDriverWhenItIsCompressedAgain) {
  const Outcome run = carry_out(GetParam(), 1);
  const auto curves = point_curves(GetParam().cohesion);
  const double first = farthest(run, 0, curves[0]), again = farthest(run, 2, curves[2]);
  std::printf("| %-6s | %3.0f | %.1f | %.1e | %.0f %% | %.1f | %.1e | %.1e | %.1e |\n", GetParam().scheme.c_str(),
              GetParam().cohesion, 1e-3 * curves[0].back().axial, first, 100 * run.max_distance,
              1e-3 * curves[2].back().axial, again, run.max_gap, run.kinetic);
  expect_sound(run);
  EXPECT_LT(first, 1e-3);
  EXPECT_LT(again, GetParam().cohesion > 0.0 ? 0.04 : 0.015);
  EXPECT_LT(run.max_gap, 5e-5);
  if (GetParam().cohesion > 0.0) { // it tears in one place, and the rest keeps contact
    EXPECT_GT(run.max_distance, 0.0);
    EXPECT_LT(run.stress_at_rest, GetParam().cohesion);
  } else {
    EXPECT_EQ(run.max_distance, 1.0);
    EXPECT_EQ(run.stress_at_rest, 0.0);
  }
}

TEST_P(UnloadedColumn, GivesTheSameLyingOnItsSide) {
  const Outcome upright = carry_out(GetParam(), 1), lying = carry_out(GetParam(), 0);
  double axial = 0.0, size = 0.0;
  ASSERT_EQ(upright.moments.size(), lying.moments.size());
  for (std::size_t i = 0; i < upright.moments.size(); ++i) {
    axial = std::max(axial, std::abs(upright.moments[i].axial - lying.moments[i].axial));
    size = std::max(size, upright.moments[i].axial);
  }
  std::printf("%-7s turned by 90 deg: %.1e\n", GetParam().scheme.c_str(), axial / size);
  EXPECT_LT(axial, 1e-8 * size) << "rounding, which the law's stiffness enlarges";
}

TEST(RattlingColumn, IsSofterThanAPointWhenItIsCompressedAgain) {
  const Outcome run = carry_out({.scheme = "gimp", .cohesion = 0.0, .flip = 0.98}, 1);
  const double point = point_curves(0.0)[2].back().axial, column = run.moments.back().axial;
  std::printf("gimp under FLIP 0.98: compressed again to %.1f kPa, a point to %.1f kPa\n", 1e-3 * column, 1e-3 * point);
  expect_sound(run);
  EXPECT_EQ(run.max_distance, 1.0);
  EXPECT_LT(column, point);
  EXPECT_GT(column, 0.5 * point);
}

std::vector<ColumnCase> all_cases() {
  std::vector<ColumnCase> cases;
  for (const char* scheme : {"linear", "gimp", "cpdi"})
    for (const double cohesion : {0.0, 200.0}) cases.push_back({scheme, cohesion});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Schemes, UnloadedColumn, testing::ValuesIn(all_cases()), [](const auto& tested) {
  return tested.param.scheme + (tested.param.cohesion > 0.0 ? "_with_cohesion" : "");
});

} // namespace
} // namespace riedel::test
