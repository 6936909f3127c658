#include "apps/bench/bare_kernel.hpp"
#include "apps/bench/case.hpp"
#include "materials/gudehus_bauer.hpp"
#include "materials/linear_elastic.hpp"
#include "support/problems.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

/// Largest difference of two columns, relative to the largest value.
double difference(const Columns& a, const Columns& b, int component) {
  double maximum = 0.0, scale = 1e-300;
  for (Index p = 0; p < a.size(); ++p) {
    maximum = std::max(maximum, std::abs(a[component][p] - b[component][p]));
    scale = std::max(scale, std::abs(a[component][p]));
  }
  return maximum / scale;
}

/// Runs the library's USL step and the kernel side by side, and compares all fields of the kernel.
template <class Law, std::size_t States, int Nodes>
void expect_the_same_step(const std::string& scheme, double faster, double tolerance) {
  // Not a multiple of eight points; the same time step for both.
  Simulation<2> library = make_block<2>(
      {.scheme = scheme, .material = std::string(Law::name), .order = "usl", .points = 1188}, catalogue());
  Points<2>& points = library.state().bodies.front().points;
  ASSERT_NE(points.size() % pack_size, 0);
  for (Index p = 0; p < points.size(); ++p) { // across a quarter of a cell
    points.velocity[0][p] = faster * points.velocity[0][p] - 1.0;
    points.velocity[1][p] = faster * points.velocity[1][p] - 0.7;
  }
  const Law law{Values(Law::parameters())};
  BareKernel<Law, States, Nodes> kernel(law, library.state().grid, points, bench_block::pressure, bench_block::flip);
  Points<2> bare = points;
  for (int i = 0; i < 40; ++i) {
    const std::vector<Index> order = points.id;
    library.step();
    ASSERT_EQ(order, points.id);
    kernel.step(library.time_step());
  }
  kernel.write(bare);
  for (int a = 0; a < 2; ++a) {
    EXPECT_LT(difference(points.position, bare.position, a), tolerance);
    EXPECT_LT(difference(points.velocity, bare.velocity, a), tolerance);
  }
  EXPECT_LT(difference(points.volume, bare.volume, 0), tolerance);
  for (int c = 0; c < 4; ++c) {
    EXPECT_LT(difference(points.deformation_gradient, bare.deformation_gradient, c), tolerance) << c;
    EXPECT_LT(difference(points.stress, bare.stress, c), tolerance) << c;
  }
  for (int s = 0; s < static_cast<int>(States); ++s) EXPECT_LT(difference(points.state, bare.state, s), tolerance);
  double strain = 0.0;
  for (Index p = 0; p < points.size(); ++p) strain = std::max(strain, points.shear_strain[0][p]);
  EXPECT_GT(strain, 20 * faster * bench_block::strain_per_step);
  EXPECT_EQ(library.state().report.substepped, 0);
}

// For an elastic law one rate is exact: the kernel's Euler step and the library's are equal.
TEST(BareKernel, IsTheLibrarysStepWithAnElasticLaw) {
  expect_the_same_step<LinearElastic, 0, 2>("linear", 100, 1e-9);
  expect_the_same_step<LinearElastic, 0, 3>("gimp", 100, 1e-9);
}

// Euler's step against Heun's: their stresses differ by a term of second order in the strain of a step, and shear parts
// are small beside it.
TEST(BareKernel, IsTheLibrarysStepWithSandAsFarAsEulersGoes) {
  expect_the_same_step<GudehusBauer, 1, 2>("linear", 5, 2e-3);
  expect_the_same_step<GudehusBauer, 1, 3>("gimp", 5, 2e-3);
}

} // namespace
} // namespace riedel::test
