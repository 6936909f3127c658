/// Patch tests through a whole step: a linear velocity field gives its exact gradient, and a body in uniform
/// translation stays free of strain and stress while it crosses cells.
#include "apps/verify/patch.hpp"
#include "core/step/grid_to_points.hpp"
#include "core/step/locate.hpp"
#include "core/step/locking.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"
#include "support/problems.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

template <int Dim>
Counts<Dim> cube(Index cells) {
  Counts<Dim> counts;
  counts.fill(cells);
  return counts;
}

template <int Dim>
Mat<Dim> random_matrix(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> unit(-size, size);
  Mat<Dim> m;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) m(i, j) = unit(random);
  return m;
}

/// A body whose points lie off the lattice and are already deformed, each differently.
template <int Dim>
State<Dim> disordered_body(std::mt19937& random) {
  State<Dim> state = elastic_state<Dim>(cube<Dim>(4), 0.5, 2, 5, [](const Vec<Dim>&) { return true; });
  state.grid.cell[0] = 0.4; // cells need not be square
  Points<Dim>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    const Mat<Dim> disorder = random_matrix<Dim>(random, 0.2);
    for (int a = 0; a < Dim; ++a) points.position[a][p] += 0.4 * disorder(0, a);
    for (int c = 0; c < Dim * Dim; ++c) points.deformation_gradient[c][p] += disorder(c / Dim, c % Dim);
  }
  return state;
}

template <int Dim>
void a_linear_field_gives_its_gradient(const std::string& name, Locking locking = Locking::none) {
  std::mt19937 random(8);
  State<Dim> state = disordered_body<Dim>(random);
  Model<Dim> model = model_with<Dim>(name);
  model.locking = locking;
  prepare_points(state, model);
  locate_points(state, model);
  const Points<Dim> before = state.bodies[0].points; // sorted
  const Mat<Dim> A = random_matrix<Dim>(random, 3.0);
  for (Index i = 0; i < state.grid.node_count(); ++i)
    state.nodes.motion[i].velocity = A * state.grid.position(state.grid.index(i)) + Vec<Dim>::Constant(7.0);

  const double dt = 0.02;
  find_cells(state, model);
  update_kinematics(state, model, dt);
  average_dilatation(state, model, dt);
  const Points<Dim>& points = state.bodies[0].points;
  const Mat<Dim> D = 0.5 * (A + A.transpose());
  const double shear = std::sqrt(2.0 * (D.squaredNorm() - square(D.trace()) / 3.0));
  for (Index p = 0; p < points.size(); ++p) {
    const Mat<Dim> F = (Mat<Dim>::Identity() + dt * A) * before.deformation_gradient_of(p);
    ASSERT_LT((points.velocity_gradient_of(p) - A).norm(), 2e-12) << "point " << p;
    ASSERT_LT((points.deformation_gradient_of(p) - F).norm(), 1e-13) << "point " << p;
    ASSERT_NEAR(points.volume[0][p], F.determinant() * before.initial_volume[0][p], 1e-14) << "point " << p;
    ASSERT_NEAR(points.rate_norm[0][p], D.norm(), 2e-12);
    ASSERT_NEAR(points.shear_strain[0][p], dt * shear, 1e-13);
  }
}

template <int Dim>
void a_body_in_uniform_translation_stays_free_of_stress(const std::string& name, StepFunction<Dim> step,
                                                        Locking locking = Locking::none) {
  const VerifyCase given{catalogue(), name, 3};
  VerifySetup<Dim> patch = make_patch<Dim>(given);
  patch.model.step = step;
  patch.model.locking = locking;
  patch.model.transfer = transfer<Dim>("flip", {{"flip", 0.98}});
  Watch watch(given);
  EXPECT_LT(error_of_translation(std::move(patch), watch), scheme<Dim>(name)->traits().translation_error);
}

class PatchTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
};

TEST_P(PatchTest, GivesTheExactGradientOfALinearVelocityField) {
  a_linear_field_gives_its_gradient<2>(GetParam());
  a_linear_field_gives_its_gradient<3>(GetParam());
}
TEST_P(PatchTest, LeavesABodyInUniformTranslationFreeOfStressInMusl) {
  a_body_in_uniform_translation_stays_free_of_stress<2>(GetParam(), musl_step<2>);
  a_body_in_uniform_translation_stays_free_of_stress<3>(GetParam(), musl_step<3>);
}
TEST_P(PatchTest, LeavesABodyInUniformTranslationFreeOfStressInUsl) {
  a_body_in_uniform_translation_stays_free_of_stress<2>(GetParam(), usl_step<2>);
  a_body_in_uniform_translation_stays_free_of_stress<3>(GetParam(), usl_step<3>);
}
TEST_P(PatchTest, LeavesABodyInUniformTranslationFreeOfStressInUsf) {
  a_body_in_uniform_translation_stays_free_of_stress<2>(GetParam(), usf_step<2>);
  a_body_in_uniform_translation_stays_free_of_stress<3>(GetParam(), usf_step<3>);
}
TEST_P(PatchTest, GivesTheSameWithFBar) {
  a_linear_field_gives_its_gradient<2>(GetParam(), Locking::f_bar);
  a_linear_field_gives_its_gradient<3>(GetParam(), Locking::f_bar);
  for (const StepFunction<2> step : {musl_step<2>, usl_step<2>, usf_step<2>})
    a_body_in_uniform_translation_stays_free_of_stress<2>(GetParam(), step, Locking::f_bar);
  a_body_in_uniform_translation_stays_free_of_stress<3>(GetParam(), musl_step<3>, Locking::f_bar);
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, PatchTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
