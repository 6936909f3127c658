/// The manufactured solutions of `riedel verify` against difference quotients: velocities, body forces, faces, and the
/// initial states.
#include "apps/verify/axis_aligned.hpp"
#include "apps/verify/ring.hpp"
#include "apps/verify/vortex.hpp"
#include "materials/neo_hookean.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

template <int Dim>
Mat<Dim> deformation_gradient(const Manufactured<Dim>& solution, const Vec<Dim>& X, double t) {
  constexpr double step = 1e-4;
  Mat<Dim> F = Mat<Dim>::Identity();
  for (int j = 0; j < Dim; ++j) {
    const Vec<Dim> d = step * Vec<Dim>::Unit(j);
    F.col(j) += (8.0 * (solution.displacement(X + d, t) - solution.displacement(X - d, t)) -
                 solution.displacement(X + 2.0 * d, t) + solution.displacement(X - 2.0 * d, t)) /
                (12.0 * step);
  }
  return F;
}

/// P = J σ F⁻ᵀ of neo-Hookean material in plane strain, or in space.
template <int Dim>
Mat<Dim> first_stress(const Manufactured<Dim>& solution, const Vec<Dim>& X, double t) {
  Values values(NeoHookean::parameters());
  for (const auto& [key, value] : solution.block.parameters) values.set(key, value);
  Mat<3> F = Mat<3>::Identity();
  F.topLeftCorner<Dim, Dim>() = deformation_gradient(solution, X, t);
  const Mat<3> sigma = to_matrix(NeoHookean(values).stress(to_sym(F * F.transpose())));
  return (F.determinant() * sigma * F.inverse().transpose()).template topLeftCorner<Dim, Dim>();
}

template <int Dim>
Vec<Dim> body_force_by_differences(const Manufactured<Dim>& solution, const Vec<Dim>& X, double t, double density) {
  const double dt = 1e-4 * solution.duration, dx = 1e-3;
  Vec<Dim> b =
      (solution.displacement(X, t + dt) - 2.0 * solution.displacement(X, t) + solution.displacement(X, t - dt)) /
      square(dt);
  for (int j = 0; j < Dim; ++j) {
    const Vec<Dim> d = dx * Vec<Dim>::Unit(j);
    b -= (first_stress<Dim>(solution, X + d, t) - first_stress<Dim>(solution, X - d, t)).col(j) / (2.0 * dx * density);
  }
  return b;
}

/// Random positions in the material and times.
template <int Dim>
std::vector<std::pair<Vec<Dim>, double>> somewhere(const Manufactured<Dim>& solution) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<std::pair<Vec<Dim>, double>> all;
  while (all.size() < 40) {
    Vec<Dim> X;
    for (int a = 0; a < Dim; ++a) X[a] = share(random) * solution.block.cells[a] * solution.block.cell;
    if (!solution.block.holds || solution.block.holds(X)) all.push_back({X, share(random) * solution.duration});
  }
  return all;
}

template <int Dim>
void expect_its_velocity_and_body_force(const Manufactured<Dim>& solution) {
  constexpr double density = 1000.0;
  double maximum = 0.0, fastest = 0.0;
  for (const auto& [X, t] : somewhere(solution)) {
    maximum = std::max(maximum, solution.body_force(X, t).norm());
    fastest = std::max(fastest, solution.velocity_at_start(X).norm());
  }
  const double dt = 1e-4 * solution.duration;
  for (const auto& [X, t] : somewhere(solution)) {
    EXPECT_LT((solution.body_force(X, t) - body_force_by_differences<Dim>(solution, X, t, density)).norm(),
              2e-4 * maximum)
        << X.transpose() << " at " << t;
    const Vec<Dim> v = (solution.displacement(X, dt) - solution.displacement(X, -dt)) / (2.0 * dt);
    EXPECT_LT((solution.velocity_at_start(X) - v).norm(), 1e-6 * fastest) << X.transpose();
  }
}

TEST(Manufactured, HasTheVelocityAndTheBodyForceOfItsMotion) {
  expect_its_velocity_and_body_force(axis_aligned_in_square(8, 0.05));
  expect_its_velocity_and_body_force(axis_aligned_in_cube(8, 0.05));
  expect_its_velocity_and_body_force(ring(8));
  expect_its_velocity_and_body_force(vortex(8));
}

TEST(Manufactured, StartsFromTheGradientOfItsDisplacement) {
  const Manufactured<3> cube = axis_aligned_in_cube(8, 0.05);
  for (const auto& [X, t] : somewhere(cube)) {
    EXPECT_LT((cube.gradient_at_start(X) - deformation_gradient<3>(cube, X, 0.0)).norm(), 1e-8);
    EXPECT_GT((cube.gradient_at_start(X) - Mat<3>::Identity()).norm(), 1e-3);
  }
  for (const Manufactured<2>& undeformed : {ring(8), vortex(8)})
    for (const auto& [X, t] : somewhere(undeformed)) EXPECT_EQ(undeformed.displacement(X, 0.0).norm(), 0.0);
}

TEST(Manufactured, LeavesItsCurvedFacesFreeOfTraction) {
  const auto traction = [](const Manufactured<2>& solution, const Vec<2>& middle, double R) {
    double maximum = 0.0;
    for (const double angle : {0.1, 0.7, 1.4})
      for (const double share : {0.1, 0.4, 0.8}) {
        const Vec<2> N(std::cos(angle), std::sin(angle));
        const Vec<2> force = first_stress<2>(solution, middle + R * N, share * solution.duration) * N;
        maximum = std::max(maximum, force.norm());
      }
    return maximum / std::get<double>(solution.block.parameters.at("youngs_modulus"));
  };
  for (const double R : {0.4, 0.6}) EXPECT_LT(traction(ring(8), {0.0, 0.0}, R), 1e-8);
  for (const double R : {0.75, 1.25}) EXPECT_LT(traction(vortex(8), {1.25, 1.25}, R), 1e-8);
  EXPECT_GT(traction(ring(8), {0.0, 0.0}, 0.5), 1e-3);
}

} // namespace
} // namespace riedel::test
