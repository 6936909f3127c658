/// The motion of points, the work done on them, and several bodies in a frame.
#include "core/io/snapshot.hpp"
#include "core/step/boundaries/rigid_body.hpp"
#include "support/problems.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <numeric>

namespace riedel::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::Pointwise;

constexpr auto everywhere = [](const auto&) { return true; };

/// 4 × 4 points that move towards one another along x, numbered against the order of the cells.
template <int Dim>
Simulation<Dim> thrown(Counts<Dim> cells) {
  State<Dim> state = elastic_state<Dim>(cells, 0.01, 1, 3, everywhere);
  Points<Dim>& points = state.bodies.front().points;
  for (int a = 0; a < Dim; ++a) std::reverse(points.position[a], points.position[a] + points.size());
  for (Index p = 0; p < points.size(); ++p) points.velocity[0][p] = points.position[0][p] < 0.02 ? 3.0 : -1.0;
  return {model_with<Dim>("gimp"), std::move(state)};
}

template <int Dim>
void expect_displacements(Counts<Dim> cells) {
  Simulation<Dim> simulation = thrown<Dim>(cells);
  const StartPlaces<Dim> start = places_of(simulation);
  const Frame first = snapshot(simulation, start);
  EXPECT_THAT(first.field("displacement").values, Each(0.0));
  for (int step = 0; step < 20; ++step) simulation.step();
  const Frame last = snapshot(simulation, start);
  const std::vector<double>& u = last.field("displacement").values;
  ASSERT_EQ(u.size(), last.position.size());
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], last.position[i] - first.position[i], 1e-15);
  EXPECT_GT(std::ranges::max(u), 1e-5);
  EXPECT_EQ(last.field("displacement").unit, "m");
}

TEST(Snapshot, TellsHowFarEachPointHasMoved) {
  expect_displacements<2>({4, 4});
  expect_displacements<3>({4, 3, 2});
}

TEST(Snapshot, TellsTheDeformationGradientRowByRow) {
  State<2> flat = elastic_state<2>({1, 1}, 1.0, 1, 4, everywhere);
  State<3> solid = elastic_state<3>({1, 1, 1}, 1.0, 1, 4, everywhere);
  for (int c = 0; c < 4; ++c) flat.bodies.front().points.deformation_gradient[c][0] = 1.1 + 0.1 * c;
  for (int c = 0; c < 9; ++c) solid.bodies.front().points.deformation_gradient[c][0] = c == 0 ? 2.0 : 0.1 * c;
  const Frame in_plane = snapshot(Simulation<2>(model_with<2>("gimp"), std::move(flat)));
  EXPECT_THAT(in_plane.field("deformation_gradient").values,
              Pointwise(DoubleNear(1e-15), {1.1, 1.2, 0.0, 1.3, 1.4, 0.0, 0.0, 0.0, 1.0}));
  const Frame in_space = snapshot(Simulation<3>(model_with<3>("gimp"), std::move(solid)));
  EXPECT_THAT(in_space.field("deformation_gradient").values,
              Pointwise(DoubleNear(1e-15), {2.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}));
}

/// Per initial volume, so that it adds up to the value in the history.
TEST(Snapshot, TellsWorkThatAddsUpToTheInternalEnergy) {
  Simulation<2> simulation = thrown<2>({4, 4});
  for (int step = 0; step < 50; ++step) simulation.step();
  const Frame frame = snapshot(simulation);
  double sum = 0.0;
  for (std::size_t p = 0; p < frame.points(); ++p)
    sum += frame.field("work").values[p] * frame.field("volume").values[p] / frame.field("volume_ratio").values[p];
  const double internal = simulation.energies().internal;
  EXPECT_GT(internal, 1e-3);
  EXPECT_NEAR(sum, internal, 1e-12 * internal);
  EXPECT_EQ(frame.field("work").unit, "J/m3");
}

/// An elastic body, then one of sand on top of it.
Simulation<2> two_bodies() {
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, [](const Vec<2>& x) { return x[1] < 0.02; });
  Body<2>& sand = state.bodies.emplace_back();
  sand.name = "sand";
  sand.material = material("gudehus_bauer");
  fill<2>(sand.points, {4, 4}, 0.01, 1, 1700.0, state_components(sand.material->states()),
          [](const Vec<2>& x) { return x[1] > 0.02; });
  for (Index p = 0; p < sand.points.size(); ++p) {
    sand.points.state[0][p] = 0.6;
    for (int c = 0; c < 3; ++c) sand.points.stress[c][p] = -50e3;
  }
  return {model_with<2>("gimp"), std::move(state)};
}

TEST(Snapshot, HoldsEveryBodyAndTellsThemApart) {
  Simulation<2> simulation = two_bodies();
  const Frame frame = snapshot(simulation, places_of(simulation));
  frame.check();
  ASSERT_EQ(frame.points(), 16U);
  std::vector<double> numbers(16);
  std::iota(numbers.begin(), numbers.end(), 0.0);
  EXPECT_EQ(frame.field("id").values, numbers);
  for (std::size_t p = 0; p < 16; ++p) {
    const bool sand = p >= 8;
    EXPECT_EQ(frame.field("body").values[p], sand ? 1.0 : 0.0);
    EXPECT_EQ(frame.position[3 * p + 1] > 0.02, sand);
    EXPECT_EQ(frame.field("mean_pressure").values[p], sand ? 50e3 : 0.0);
    if (sand)
      EXPECT_EQ(frame.field("void_ratio").values[p], 0.6);
    else
      EXPECT_TRUE(std::isnan(frame.field("void_ratio").values[p])) << "Hooke's law knows none";
  }
  EXPECT_TRUE(frame.field("id").whole);
  EXPECT_TRUE(frame.field("body").whole);
  EXPECT_FALSE(frame.field("stress").whole);
}

/// An elastic body, and a block of four rigid points above it that moves down.
Simulation<2> under_a_platen(const std::string& scheme_name) {
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, [](const auto& x) { return x[1] < 0.02; });
  Model<2> model = model_with<2>(scheme_name);
  NodeBox<2> cells{.first = {3, 6}, .last = {7, 7}, .axis = 1}; // the grid has a margin of three cells
  Values values(RigidBody<2>::parameters());
  values.set("velocity", std::vector{-2.0});
  model.conditions.push_back(std::make_unique<RigidBody<2>>("platen", cells, values));
  return {std::move(model), std::move(state)};
}

TEST(Snapshot, HoldsRigidPointsAsAFurtherBody) {
  for (const char* scheme_name : {"linear", "gimp", "cpdi", "cpdi2"}) {
    Simulation<2> simulation = under_a_platen(scheme_name);
    const StartPlaces<2> start = places_of(simulation);
    const Frame first = snapshot(simulation, start);
    for (int step = 0; step < 3; ++step) simulation.step();
    const Frame last = snapshot(simulation, start);
    last.check();
    ASSERT_EQ(last.points(), 12U);
    const double time = simulation.state().time;
    for (std::size_t p = 8; p < 12; ++p) {
      EXPECT_EQ(last.field("body").values[p], 1.0);
      EXPECT_EQ(last.field("id").values[p], static_cast<double>(p));
      EXPECT_EQ(last.field("velocity").values[3 * p + 1], -2.0);
      EXPECT_NEAR(last.field("displacement").values[3 * p + 1], -2.0 * time, 1e-15);
      EXPECT_NEAR(first.position[3 * p + 1], 0.035, 1e-15);
      EXPECT_NEAR(first.field("volume").values[p], 1e-4, 1e-15);
      EXPECT_TRUE(std::isnan(last.field("mean_pressure").values[p])) << "it bears no stress of its own";
    }
    EXPECT_EQ(deformable_points(last).points(), 8U);
    EXPECT_THAT(deformable_points(last).field("body").values, Each(0.0));
    Frame diverged = last;
    for (Field& field : diverged.fields)
      if (field.name == "mean_pressure") field.values[0] = std::nan("");
    EXPECT_EQ(deformable_points(diverged).points(), 8U) << "a point whose stress is lost is no rigid one";
  }
}

} // namespace
} // namespace riedel::test
