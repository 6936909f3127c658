/// A simulation as a frame: points in the order of their ids, tensors in ParaView's order, the domains of the scheme.
#include "core/base/tensor.hpp"
#include "core/io/snapshot.hpp"
#include "support/problems.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

constexpr auto everywhere = [](const auto&) { return true; };

/// 4 × 4 points whose numbers run against the order of the cells, so that sorting changes all their places.
Simulation<2> reversed_points() {
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, everywhere);
  Points<2>& points = state.bodies.front().points;
  for (int a = 0; a < 2; ++a) std::reverse(points.position[a], points.position[a] + points.size());
  for (Index p = 0; p < points.size(); ++p) points.mass[0][p] = 1.0 + p;
  return {model_with<2>("gimp"), std::move(state)};
}

template <int Dim>
Simulation<Dim> single_point(const std::string& scheme_name, const Mat<Dim>& F, const Vec<Dim>& half_size) {
  Counts<Dim> cells;
  cells.fill(1);
  State<Dim> state = elastic_state<Dim>(cells, 1.0, 1, 4, everywhere);
  Points<Dim>& points = state.bodies.front().points;
  for (int i = 0; i < Dim; ++i) {
    points.half_size[i][0] = half_size[i];
    for (int j = 0; j < Dim; ++j) points.deformation_gradient[i * Dim + j][0] = F(i, j);
  }
  return {model_with<Dim>(scheme_name), std::move(state)};
}

std::vector<std::string> names_of(const Frame& frame) {
  std::vector<std::string> names;
  for (const Field& field : frame.fields) names.push_back(field.name);
  return names;
}

} // namespace

TEST(Snapshot, PutsPointsInTheOrderOfTheirIds) {
  const Simulation<2> simulation = reversed_points();
  ASSERT_FALSE(std::ranges::is_sorted(simulation.state().bodies.front().points.id)) << "nothing was to be put in order";
  const Frame frame = snapshot(simulation);
  frame.check();
  ASSERT_EQ(frame.points(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(frame.field("id").values[i], static_cast<double>(i));
    EXPECT_EQ(frame.field("mass").values[i], 1.0 + static_cast<double>(i));
    EXPECT_NEAR(frame.position[3 * i], 0.01 * (3.5 - static_cast<double>(i % 4)), 1e-12);
    EXPECT_NEAR(frame.position[3 * i + 1], 0.01 * (3.5 - static_cast<double>(i / 4)), 1e-12);
    EXPECT_EQ(frame.position[3 * i + 2], 0.0);
    EXPECT_NEAR(frame.corners[12 * i], frame.position[3 * i] - 0.005, 1e-12) << "the domain of another point";
  }
}

TEST(Snapshot, CarriesTimeStrainAndTheFieldsThatFilesPromise) {
  Simulation<2> simulation = reversed_points();
  simulation.step();
  const Frame frame = snapshot(simulation, places_of(simulation), {{"u_over_h", 0.03}});
  EXPECT_EQ(frame.time, simulation.state().time);
  EXPECT_EQ(frame.scalar("u_over_h"), 0.03);
  EXPECT_EQ(frame.dimension, 2);
  EXPECT_THAT(names_of(frame),
              ElementsAre("id", "body", "shear_strain", "stress", "mean_pressure", "q", "work", "rate_norm", "velocity",
                          "displacement", "volume", "mass", "volume_ratio", "polar_rotation", "deformation_gradient"));
  EXPECT_FALSE(snapshot(simulation).has("displacement")) << "nobody said from where";
}

TEST(Snapshot, WritesTensorsInParaViewsOrderAndNotInMandels) {
  Simulation<3> simulation = single_point<3>("gimp", Mat<3>::Identity(), Vec<3>::Constant(0.5));
  Mat<3> stress;
  stress << -11, 12, 13, 12, -22, 23, 13, 23, -33;
  for (std::size_t c = 0; c < 6; ++c)
    simulation.state().bodies.front().points.stress[static_cast<int>(c)][0] = to_sym(stress).m[c];
  const Frame frame = snapshot(simulation);
  EXPECT_THAT(frame.field("stress").values, Pointwise(DoubleNear(1e-12), {-11.0, -22.0, -33.0, 12.0, 23.0, 13.0}));
  EXPECT_DOUBLE_EQ(frame.field("mean_pressure").values[0], 22.0); // compression positive
  // q² = ½ ((11 − 22)² + (22 − 33)² + (33 − 11)²) + 3 (12² + 13² + 23²)
  EXPECT_NEAR(frame.field("q").values[0], std::sqrt(363.0 + 2526.0), 1e-9);
}

TEST(Snapshot, DrawsAShearedDomainCounterClockwise) {
  Mat<2> F;
  F << 1.0, 0.5, 0.0, 1.2;
  const Frame frame = snapshot(single_point<2>("cpdi", F, {0.4, 0.5}));
  // x ± F s with s = (0.4, 0.5): half edges (0.4, 0) and (0.25, 0.6) about (0.5, 0.5)
  EXPECT_THAT(frame.corners,
              Pointwise(DoubleNear(1e-12), {-0.15, -0.1, 0.0, 0.65, -0.1, 0.0, 1.15, 1.1, 0.0, 0.35, 1.1, 0.0}));
}

TEST(Snapshot, DrawsTheRealQuadrilateralOfADomainWithCornersOfItsOwn) {
  Simulation<2> simulation = single_point<2>("cpdi2", Mat<2>::Identity(), {0.4, 0.5});
  Points<2>& points = simulation.state().bodies.front().points;
  points.scheme_data[3 * 2 + 0][0] += 0.3; // the upper right corner
  points.scheme_data[3 * 2 + 1][0] += 0.2;
  EXPECT_THAT(snapshot(simulation).corners,
              Pointwise(DoubleNear(1e-12), {0.1, 0.0, 0.0, 0.9, 0.0, 0.0, 1.2, 1.2, 0.0, 0.1, 1.0, 0.0}));
}

TEST(Snapshot, DrawsABoxInTheOrderOfVtksHexahedron) {
  const Frame frame = snapshot(single_point<3>("cpdi", Mat<3>::Identity(), {0.1, 0.2, 0.3}));
  EXPECT_THAT(frame.corners,
              Pointwise(DoubleNear(1e-12), {0.4, 0.3, 0.2, 0.6, 0.3, 0.2, 0.6, 0.7, 0.2, 0.4, 0.7, 0.2,
                                            0.4, 0.3, 0.8, 0.6, 0.3, 0.8, 0.6, 0.7, 0.8, 0.4, 0.7, 0.8}));
}

TEST(Snapshot, TellsThePolarRotationWhateverTheStretch) {
  const Mat<2> R = Eigen::Rotation2Dd(20.0 * std::numbers::pi / 180).toRotationMatrix();
  Mat<2> U;
  U << 1.3, 0.2, 0.2, 0.8;
  const auto rotation = [](const Mat<2>& F) {
    return snapshot(single_point<2>("cpdi", F, {0.5, 0.5})).field("polar_rotation").values[0];
  };
  EXPECT_NEAR(rotation(R * U), 20.0, 1e-12);
  EXPECT_NEAR(rotation(R.transpose() * U), -20.0, 1e-12);
  EXPECT_NEAR(rotation(U), 0.0, 1e-12);
}

TEST(Snapshot, ShowsTheStateOfTheLawAndTheAverageWhenThereIsOne) {
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, everywhere);
  Body<2>& body = state.bodies.front();
  body.material = material("gudehus_bauer");
  fill<2>(body.points, {4, 4}, 0.01, 1, 1700.0, state_components(body.material->states()), everywhere);
  for (Index p = 0; p < body.points.size(); ++p) {
    body.points.state[0][p] = 0.6 + 0.01 * p;
    for (int c = 0; c < 3; ++c) body.points.stress[c][p] = -50e3;
  }
  body.averager = catalogue().in_2d.averagers.find("gauss").make(0.01, catalogue().in_2d.searches.entries()[0].make());
  const Frame frame = snapshot(Simulation<2>(model_with<2>("gimp"), std::move(state)));
  EXPECT_DOUBLE_EQ(frame.field("void_ratio").values[7], 0.67);
  EXPECT_EQ(frame.field("averaged").unit, frame.field("rate_norm").unit);
  EXPECT_EQ(frame.field("stress").unit, "Pa");
}

} // namespace riedel::test
