/// A specimen of cells under every scheme against one point of the same law, whose curves were checked against
/// independent programs.
#include "apps/element/drivers.hpp"
#include "apps/element/keys.hpp"
#include "support/csv.hpp"
#include "support/problems.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using Settings = std::vector<std::string>;

struct Columns3 {
  std::vector<double> strain, angle, void_ratio, stress;
};

ElementCurve carry_out(const std::string& test, const std::string& driver, const Settings& settings) {
  CaseFile file = CaseFile::empty();
  file.override_with("test=" + test);
  file.override_with("driver.kind=" + driver);
  for (const std::string& setting : settings) file.override_with(setting);
  const Values values = element_case(file, catalogue()).values;
  const ElementWatch watch{.at_row = [](const ElementRow&, const MaterialPoint&) {}, .stop = [] { return false; }};
  const ElementCase given(values);
  return element_driver(given).run(given, catalogue(), watch);
}

Columns3 columns(const ElementCurve& curve) {
  Columns3 all;
  for (const ElementRow& row : curve.rows) {
    all.strain.push_back(curve.test == "shear" ? row.gamma : row.eps[0]);
    all.angle.push_back(row.phi_mob);
    all.void_ratio.push_back(row.void_ratio);
    all.stress.push_back(row.sigma[0]);
  }
  return all;
}

/// The same curve, over the whole test; an oedometer has no limiting angle, so that σ_1 is compared there.
void expect_same(const std::string& test, Settings settings, const Settings& of_specimen) {
  const Columns3 point = columns(carry_out(test, "point", settings));
  settings.insert(settings.end(), of_specimen.begin(), of_specimen.end());
  const ElementCurve curve = carry_out(test, "mpm", settings);
  const Columns3 cells = columns(curve);
  double angle = 0.0, density = 0.0, stress = 0.0;
  for (std::size_t row = 0; row < cells.strain.size(); ++row) {
    const double strain = cells.strain[row];
    if (strain > point.strain.back()) continue;
    angle = std::max(angle, std::abs(interpolate(point.strain, point.angle, strain) - cells.angle[row]));
    density = std::max(density, std::abs(interpolate(point.strain, point.void_ratio, strain) - cells.void_ratio[row]));
    stress = std::max(stress, std::abs(1.0 - cells.stress[row] / interpolate(point.strain, point.stress, strain)));
  }
  std::string name = test;
  for (const std::string& setting : of_specimen) name += " " + setting;
  const ElementEnergies& energies = *curve.energies;
  std::printf("%s: %.4f deg, %.1e in e, %.1e in sigma_1, kinetic over internal %.1e, spread %.1e\n", name.c_str(),
              angle, density, stress, energies.kinetic_over_internal, energies.stress_spread);
  EXPECT_EQ(curve.failure, "") << name;
  EXPECT_GE(cells.strain.back(), 0.99 * point.strain.back()) << name; // a row later
  EXPECT_LT(angle, 0.03) << name;
  EXPECT_LT(density, 1e-4) << name;
  EXPECT_LT(stress, 5e-3) << name;
  EXPECT_LT(energies.kinetic_over_internal, 1e-3) << name;
  EXPECT_NEAR(energies.external / energies.internal, 1.0, 0.01) << name;
  EXPECT_LT(energies.stress_spread, 0.02) << name;
}

class ElementSpecimen : public testing::TestWithParam<std::string> {
protected:
  [[nodiscard]] Settings with(Settings settings) const {
    settings.insert(settings.begin(), "scheme=" + GetParam());
    return settings;
  }
};

TEST_P(ElementSpecimen, FollowsThePointInPlaneStrainCompression) {
  expect_same("biaxial", {}, with({"grid.cells=1"}));
  expect_same("biaxial", {}, with({"grid.cells=4"}));
  expect_same("biaxial", {"specimen.void_ratio=0.9"}, with({"grid.cells=4"}));
  expect_same("biaxial", {}, with({"grid.cells=1", "grid.dimensions=3"}));
}
/// Up to the peak: beyond it the law has many solutions, and a scheme may find one with a shear band.
TEST_P(ElementSpecimen, FollowsThePointWithAFreeInterior) {
  expect_same("biaxial", {"loading.final_strain=0.013"}, with({"grid.cells=4", "specimen.interior=free"}));
  expect_same("oedometer", {}, with({"grid.cells=4", "specimen.interior=free"}));
  expect_same("triaxial", {"loading.final_strain=0.03"}, with({"grid.cells=2", "specimen.interior=free"}));
}
TEST_P(ElementSpecimen, FollowsThePointInEveryOrderOfTheStep) {
  for (const std::string order : {"usl", "usf"})
    expect_same("biaxial", {}, with({"grid.cells=1", "time.order=" + order}));
}
TEST_P(ElementSpecimen, FollowsThePointInTriaxialCompressionInThreeDimensions) {
  expect_same("triaxial", {"loading.final_strain=0.15"}, with({"grid.cells=1"}));
  expect_same("triaxial", {"loading.final_strain=0.06"}, with({"grid.cells=2"}));
}
TEST_P(ElementSpecimen, FollowsThePointInShearWithFreeDilatancy) {
  expect_same("shear", {"loading.final_strain=0.3"}, with({"grid.cells=1"}));
  expect_same("shear", {"loading.final_strain=0.06"}, with({"grid.cells=4"}));
  expect_same("shear", {"loading.final_strain=0.06"}, with({"grid.cells=1", "grid.dimensions=3"}));
}
TEST_P(ElementSpecimen, FollowsThePointInTheOedometer) {
  expect_same("oedometer", {}, with({"grid.cells=1"}));
  expect_same("oedometer", {"specimen.void_ratio=0.9"}, with({"grid.cells=4"}));
  expect_same("oedometer", {}, with({"grid.cells=1", "grid.dimensions=3"}));
}

INSTANTIATE_TEST_SUITE_P(Registry, ElementSpecimen, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

TEST(ElementSpecimen, TakesAnyLaw) {
  expect_same("biaxial", {"material.model=von_wolffersdorff", "specimen.void_ratio=0.7"}, {});
  expect_same("shear",
              {"material.model=von_wolffersdorff", "material.intergranular_strain=true", "specimen.void_ratio=0.7",
               "loading.final_strain=0.1"},
              {});
  expect_same("oedometer", {"material.model=neo_hookean", "loading.final_strain=0.02"}, {});
}

TEST(ElementSpecimen, TellsWhenItIsLoadedTooFast) {
  const ElementCurve fast = carry_out("biaxial", "mpm", {"loading.speed=1.0"});
  EXPECT_GT(fast.energies->kinetic_over_internal, 0.05);
}

/// Dense sand softens, so that a specimen of many cells does not stay homogeneous; the spread of stress says so.
TEST(ElementSpecimen, TellsWhenItIsNoLongerHomogeneous) {
  const ElementCurve banded = carry_out("biaxial", "mpm", {"grid.cells=8", "specimen.interior=free"});
  EXPECT_GT(banded.energies->stress_spread, 0.5);
}

} // namespace
} // namespace riedel::test
