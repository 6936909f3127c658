/// Jaumann's rate and that of Green and Naghdi: in a rigid rotation, where they agree, and in simple shear of a
/// hypo-elastic material, where closed forms differ. Motions are prescribed and pass through the solver's stress
/// update.
#include "core/step/rotation.hpp"
#include "core/step/stress_update.hpp"
#include "support/carrier.hpp"
#include "support/law.hpp"
#include "verification/biaxial.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

/// Points that all have the same motion.
template <int Dim>
class Motion {
public:
  static constexpr Index size = 13; // the last pack is not full
  State<Dim> state;
  Model<Dim> model;

  Motion(std::shared_ptr<const Material> law, ObjectiveRate objective, const Mat<Dim>& F) : F_(F) {
    omp_set_num_threads(1); // too small to share
    model.objective_rate = objective;
    Body<Dim>& body = state.bodies.emplace_back();
    body.material = std::move(law);
    points().resize(size, state_components(body.material->states()));
    points().volume.fill(0, 1.0);
  }
  Points<Dim>& points() { return state.bodies[0].points; }

  /// One step in which F becomes `F`: L follows from (I + Δt L) F_n = F.
  void move_to(const Mat<Dim>& F) {
    const Mat<Dim> L = F * F_.inverse() - Mat<Dim>::Identity(); // Δt = 1
    for (int c = 0; c < Dim * Dim; ++c) {
      points().velocity_gradient.fill(c, L(c / Dim, c % Dim));
      points().deformation_gradient.fill(c, F(c / Dim, c % Dim));
    }
    F_ = F;
    update_stress(state, model, 1.0);
  }

private:
  Mat<Dim> F_;
};

Sym<double> tensor(const Columns& field, int first, Index p) {
  Sym<double> s;
  for (int c = 0; c < 6; ++c) s.m[static_cast<std::size_t>(c)] = field[first + c][p];
  return s;
}

/// A stretched body rotates by 20 times 17°: as R U with the same U. Green and Naghdi's rate depends on R alone, for
/// any step size.
template <int Dim>
void turns_exactly() {
  const Vec<3> axis = Dim == 2 ? Vec<3>(0, 0, 1) : Vec<3>(2, -1, 3).normalized();
  Mat<3> U;
  U << 2.5, 0.7, 0, 0.7, 0.6, 0, 0, 0, 1;
  if (Dim == 3) U(0, 2) = U(2, 0) = 0.3, U(1, 2) = U(2, 1) = -0.2, U(2, 2) = 0.4;
  const auto F = [&](const Mat<3>& R) -> Mat<Dim> { return (R * U).template topLeftCorner<Dim, Dim>(); };

  Motion<Dim> motion(std::make_shared<Carrier>(), ObjectiveRate::green_naghdi, F(Mat<3>::Identity()));
  std::mt19937 random(6);
  std::array<Sym<double>, Motion<Dim>::size> stress, fabric;
  for (std::size_t p = 0; p < stress.size(); ++p) {
    stress[p] = random_stress(random, 1e5);
    fabric[p] = random_rate(random);
    if (Dim == 2) stress[p].m[4] = stress[p].m[5] = fabric[p].m[4] = fabric[p].m[5] = 0.0;
    for (int c = 0; c < 6; ++c) {
      motion.points().stress[c][p] = stress[p].m[static_cast<std::size_t>(c)];
      motion.points().state[c + 1][p] = fabric[p].m[static_cast<std::size_t>(c)];
    }
  }
  for (int step = 1; step <= 20; ++step) {
    const Mat<3> R = Eigen::AngleAxisd(step * 17.0 * std::numbers::pi / 180.0, axis).toRotationMatrix();
    motion.move_to(F(R));
    for (std::size_t p = 0; p < stress.size(); ++p) {
      const Index i = static_cast<Index>(p);
      ASSERT_LT(norm(tensor(motion.points().stress, 0, i) - rotated(stress[p], R)), 1e-13 * norm(stress[p])) << step;
      ASSERT_LT(norm(tensor(motion.points().state, 1, i) - rotated(fabric[p], R)), 1e-13 * norm(fabric[p])) << step;
    }
  }
  EXPECT_TRUE(std::isfinite(motion.state.internal_work)) << "lanes past the last point";
}

TEST(GreenNaghdiRate, TurnsTheStressOfAStretchedBodyExactlyHoweverLargeTheStep) {
  turns_exactly<2>();
  turns_exactly<3>();
}

struct Shear {
  double along, across; ///< σ_11 = −σ_22 and σ_12, over μ
};
/// σ̇ = 2μ D + Wσ − σW rotates about a fixed axis: a circle.
Shear jaumann(double gamma) { return {1.0 - std::cos(gamma), std::sin(gamma)}; }
/// With tan β = γ/2 the stress in the frame of R is 4μ [ln cos β, β − ½ tan β], rotated back by β.
Shear green_naghdi(double gamma) {
  const double beta = std::atan(0.5 * gamma), x = 2.0 * std::log(std::cos(beta)), y = 2.0 * beta - std::tan(beta);
  const double c = std::cos(2.0 * beta), s = std::sin(2.0 * beta);
  return {2.0 * (c * x + s * y), 2.0 * (c * y - s * x)};
}

/// Simple shear to γ = 6 of Hooke's law in rates. @return the largest error of the stress along the path, over μ
template <int Dim>
double error_in_simple_shear(ObjectiveRate objective, Shear (*exact)(double gamma), int steps) {
  constexpr double E = 2.6e6, nu = 0.3, mu = E / (2.0 * (1.0 + nu));
  Motion<Dim> motion(material("linear_elastic", {{"youngs_modulus", E}, {"poissons_ratio", nu}}), objective,
                     Mat<Dim>::Identity());
  double worst = 0.0;
  for (int step = 1; step <= steps; ++step) {
    Mat<Dim> F = Mat<Dim>::Identity();
    F(0, 1) = 6.0 * step / steps;
    motion.move_to(F);
    const Shear expected = exact(F(0, 1));
    const Sym<double> s = {{expected.along, -expected.along, 0, std::numbers::sqrt2 * expected.across, 0, 0}};
    for (const Index p : {0, 12}) worst = std::max(worst, norm(tensor(motion.points().stress, 0, p) - mu * s) / mu);
  }
  return worst;
}

template <int Dim>
void converges(const char* name, ObjectiveRate objective, Shear (*exact)(double gamma)) {
  std::array<double, 3> errors;
  for (std::size_t i = 0; i < 3; ++i) errors[i] = error_in_simple_shear<Dim>(objective, exact, 300 << (2 * i));
  const double first = 0.5 * std::log2(errors[0] / errors[1]), second = 0.5 * std::log2(errors[1] / errors[2]);
  std::printf("%s, %d-D: errors over mu %.2e %.2e %.2e for steps of gamma 0.02, 0.005, 0.00125; orders %.2f %.2f\n",
              name, Dim, errors[0], errors[1], errors[2], first, second);
  EXPECT_NEAR(second, 1.0, 0.03);
  EXPECT_LT(errors[2], 2e-3);
}

TEST(ObjectiveRates, FollowTheirClosedFormsInSimpleShearWithFirstOrderInTheStep) {
  converges<2>("Jaumann", ObjectiveRate::jaumann, jaumann);
  converges<3>("Jaumann", ObjectiveRate::jaumann, jaumann);
  converges<2>("Green-Naghdi", ObjectiveRate::green_naghdi, green_naghdi);
  converges<3>("Green-Naghdi", ObjectiveRate::green_naghdi, green_naghdi);
}

TEST(ObjectiveRates, AreChosenByTheCase) {
  EXPECT_EQ(make_biaxial(biaxial_values({}), catalogue()).model().objective_rate, ObjectiveRate::jaumann);
  EXPECT_EQ(make_biaxial(biaxial_values({"time.objective_rate=green_naghdi"}), catalogue()).model().objective_rate,
            ObjectiveRate::green_naghdi);
}

} // namespace
} // namespace riedel::test
