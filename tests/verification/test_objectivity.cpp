/// A block in rigid rotation: its stress rotates with it, component by component, and nothing else changes. The
/// rotation is prescribed by L = W in every point and passes through the solver's stress update.
#include "core/step/rotation.hpp"
#include "core/step/stress_update.hpp"
#include "support/carrier.hpp"
#include "support/law.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

template <int Dim>
Mat<3> spin() {
  Mat<3> W = Mat<3>::Zero();
  W(0, 1) = -4.0, W(1, 0) = 4.0; // counter-clockwise
  if (Dim == 3) W(0, 2) = 2.0, W(2, 0) = -2.0, W(1, 2) = 1.0, W(2, 1) = -1.0;
  return W;
}

/// Points of different stress that rotate by about 80°.
template <int Dim>
struct TurningBlock {
  static constexpr Index size = 301; // two blocks, the last pack not full
  static constexpr int steps = 350;
  static constexpr double dt = 1e-3;
  State<Dim> state;

  explicit TurningBlock(std::shared_ptr<const Material> law) {
    Body<Dim>& body = state.bodies.emplace_back();
    body.name = "block";
    body.material = std::move(law);
    Points<Dim>& points = body.points;
    points.resize(size, state_components(body.material->states()));
    points.volume.fill(0, 1.0);
    std::mt19937 random(9);
    const Mat<3> W = spin<Dim>();
    const int e = state_column(body.material->states(), "void_ratio");
    for (Index p = 0; p < size; ++p) {
      Sym<double> sigma = random_stress(random, 1e4 + 100.0 * p);
      if (Dim == 2) sigma.m[4] = sigma.m[5] = 0.0;
      for (int c = 0; c < 6; ++c) points.stress[c][p] = sigma.m[c];
      for (int c = 0; c < Dim * Dim; ++c) points.velocity_gradient[c][p] = W(c / Dim, c % Dim);
      for (int s = 0; s < points.state.components(); ++s) points.state[s][p] = 0.01 * p + s;
      if (e >= 0) points.state[e][p] = 0.6;
    }
    if (e >= 0) points.state.fill(e + 1, 0.0); // not separated
    int column = 0;
    for (const StateVariable& variable : body.material->states()) {
      for (const int c : {4, 5}) // no shear out of the plane
        if (Dim == 2 && variable.components == 6) points.state.fill(column + c, 0.0);
      column += variable.components;
    }
  }
  void turn() {
    for (int i = 0; i < steps; ++i) update_stress(state, Model<Dim>{}, dt);
  }
  /// Of all steps together, by the solver's own rule (Cayley's) and by the angle itself.
  static Mat<3> rotation_by_rule() {
    Mat<3> Q = Mat<3>::Identity();
    for (int i = 0; i < steps; ++i) Q = rotation_of(spin<Dim>(), dt) * Q;
    return Q;
  }
  static Mat<3> exact_rotation() {
    const Mat<3> W = spin<Dim>();
    const Vec<3> w(W(2, 1), W(0, 2), W(1, 0));
    return Eigen::AngleAxisd(w.norm() * steps * dt, w.normalized()).toRotationMatrix();
  }
};

Sym<double> tensor(const Columns& field, int first, Index p) {
  Sym<double> s;
  for (int c = 0; c < 6; ++c) s.m[c] = field[first + c][p];
  return s;
}

/// Tensors rotate, scalars do not.
template <int Dim>
void expect_turned_state(const TurningBlock<Dim>& block, const Points<Dim>& before, Index p) {
  const Body<Dim>& body = block.state.bodies[0];
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    if (variable.components == 6) {
      const Sym<double> start = tensor(before.state, column, p), now = tensor(body.points.state, column, p);
      ASSERT_LT(norm(now - rotated(start, block.rotation_by_rule())), 1e-11 * norm(start)) << variable.name;
    } else {
      ASSERT_EQ(body.points.state[column][p], before.state[column][p]) << variable.name;
    }
    column += variable.components;
  }
}

template <int Dim>
void stress_turns(const std::string& law) {
  TurningBlock<Dim> block(material(law));
  const Points<Dim> before = block.state.bodies[0].points;
  block.turn();
  const Points<Dim>& points = block.state.bodies[0].points;
  const Mat<3> Q = block.rotation_by_rule(), exact = block.exact_rotation();
  EXPECT_GT((Q - Mat<3>::Identity()).norm(), 1.0) << "hardly turned";
  for (Index p = 0; p < points.size(); ++p) {
    const Sym<double> start = tensor(before.stress, 0, p), now = tensor(points.stress, 0, p);
    ASSERT_LT(norm(now - rotated(start, Q)), 1e-11 * norm(start)) << "point " << p;
    ASSERT_LT(norm(now - rotated(start, exact)), 1e-5 * norm(start)) << "point " << p;
    expect_turned_state(block, before, p);
  }
  EXPECT_NEAR(block.state.internal_work, 0.0, 1e-6);
}

class ObjectivityTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
};

TEST_P(ObjectivityTest, TurnsTheStressOfABlockInRigidRotation) {
  stress_turns<2>(GetParam());
  stress_turns<3>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(EveryLaw, ObjectivityTest, testing::ValuesIn(law_names()),
                         [](const auto& tested) { return tested.param; });

template <int Dim>
void tensor_state_turns() {
  TurningBlock<Dim> block(std::make_shared<Carrier>());
  const Points<Dim> before = block.state.bodies[0].points;
  block.turn();
  for (Index p = 0; p < block.size; ++p) expect_turned_state(block, before, p);
}

TEST(Objectivity, TurnsTensorsAmongTheStateVariablesAndLeavesScalarsAlone) {
  omp_set_num_threads(1);
  tensor_state_turns<2>();
  tensor_state_turns<3>();
}

/// A rotation by 90° exchanges σ_xx and σ_yy; the wrong sense would change the sign of a shear stress on the way.
TEST(Objectivity, MakesAShearStressOfAxialStressInTheSenseOfTheRotation) {
  TurningBlock<2> block(material("linear_elastic"));
  Points<2>& points = block.state.bodies[0].points;
  for (const int c : {1, 2, 3}) points.stress.fill(c, 0.0);
  points.stress.fill(0, -1e3);                                                                 // pressed along x
  for (int i = 0; i < 200; ++i) update_stress(block.state, {}, std::numbers::pi / 16.0 / 200); // 45° counter-clockwise
  EXPECT_NEAR(points.stress[0][0], -500.0, 0.01);
  EXPECT_NEAR(points.stress[1][0], -500.0, 0.01);
  EXPECT_NEAR(points.stress[3][0] / std::numbers::sqrt2, -500.0, 0.01) << "pressed along the diagonal x = y";
}

} // namespace
} // namespace riedel::test
