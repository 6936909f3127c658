/// What every registered law must satisfy, with each of its switches off and on.
#include "core/step/rotation.hpp"
#include "support/law.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

class EveryLaw : public testing::TestWithParam<LawCase> {
protected:
  static constexpr Index size = 45;
  /// Points of varied stress, density and rate, some of them with a step too large for one sub-step.
  LawBench bench(const Mat<3>& Q = Mat<3>::Identity()) const {
    LawBench b(material(GetParam().name, GetParam().with), size);
    std::mt19937 random(3);
    std::vector<Sym<double>> rates;
    for (Index p = 0; p < size; ++p) {
      const Sym<double> sigma = random_stress(random, 1e3 * (1 + p)), D = random_rate(random);
      rates.push_back(rotated((p % 7 == 0 ? 50.0 : 1.0) * D, Q));
      b.put(p, rotated(sigma, Q), 0.6 + 0.005 * p, rates.back());
    }
    if (!tensors_of(b).empty()) { // a small strain that affects the law, except at the first point
      for (Index p = 0; p < size; ++p) b.put_rate(p, rotated((p == 0 ? 0.0 : 1.0) * random_rate(random), Q));
      b.integrate(5e-5);
      for (Index p = 0; p < size; ++p) b.put_rate(p, rates[static_cast<std::size_t>(p)]);
      b.report = {};
    }
    return b;
  }
  static std::vector<std::string> tensors_of(const LawBench& b) {
    std::vector<std::string> names;
    for (const StateVariable& variable : b.law->states())
      if (variable.components == 6) names.push_back(variable.name);
    return names;
  }
};

TEST_P(EveryLaw, ChangesNothingInAZeroIncrement) {
  LawBench still = bench();
  const LawBench before = bench();
  for (int c = 0; c < 6; ++c) still.rate.fill(c, 0.0);
  still.integrate(1e-4);
  EXPECT_EQ(still.report.failures, 0);
  for (Index p = 0; p < size; ++p) {
    for (int c = 0; c < 6; ++c) EXPECT_EQ(still.stress[c][p], before.stress[c][p]);
    for (int s = 0; s < still.state.components(); ++s) EXPECT_EQ(still.state[s][p], before.state[s][p]);
  }
}

TEST_P(EveryLaw, GivesASliceTheBitsOfTheWhole) {
  LawBench whole = bench(), sliced = bench();
  whole.integrate(1e-4);
  for (const Range part : {Range{0, 8}, Range{8, 11}, Range{11, 40}, Range{40, 45}}) sliced.integrate(1e-4, part);
  for (Index p = 0; p < size; ++p) {
    for (int c = 0; c < 6; ++c) EXPECT_EQ(whole.stress[c][p], sliced.stress[c][p]) << "point " << p;
    for (int s = 0; s < whole.state.components(); ++s)
      EXPECT_EQ(whole.state[s][p], sliced.state[s][p]) << "point " << p;
  }
}

TEST_P(EveryLaw, GivesRotatedTensorsInARotatedFrame) {
  const Mat<3> Q = slanted_rotation();
  LawBench plain = bench(), turned = bench(Q);
  plain.integrate(1e-5);
  turned.integrate(1e-5);
  for (Index p = 0; p < size; ++p) {
    EXPECT_LT(norm(turned.stress_of(p) - rotated(plain.stress_of(p), Q)), 1e-9 * norm(plain.stress_of(p)));
    for (const std::string& name : tensors_of(plain)) {
      const Sym<double> tensor = plain.tensor_of(name, p);
      EXPECT_GT(norm(tensor), 0.0);
      EXPECT_LT(norm(turned.tensor_of(name, p) - rotated(tensor, Q)), 1e-9 * norm(tensor)) << name;
    }
  }
}

TEST_P(EveryLaw, NamesTheFirstPointThatItCannotIntegrate) {
  LawBench b = bench();
  const Sym<double> before = b.stress_of(20);
  b.rate[1][20] = std::numeric_limits<double>::quiet_NaN();
  b.integrate(1e-5);
  EXPECT_EQ(b.report.failures, 1);
  EXPECT_EQ(b.report.first_failure, 20);
  EXPECT_FALSE(b.report.reason.empty());
  EXPECT_EQ(norm(b.stress_of(20) - before), 0.0) << "a point that fails keeps its stress";
}

TEST_P(EveryLaw, RefusesParametersOutOfRangeAndTellsTheRange) {
  const auto& entry = catalogue().materials.find(GetParam().name);
  for (const Key& key : entry.description.parameters) {
    if (!std::isfinite(key.bounds.lower)) continue;
    try {
      auto values = GetParam().with;
      values[key.name] = key.bounds.lower - 1.0;
      material(GetParam().name, values);
      ADD_FAILURE() << key.name << " below its range was accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(key.name), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(key.bounds.text()), std::string::npos) << error.what();
    }
  }
}

TEST_P(EveryLaw, TellsAWaveSpeedThatNoIncrementExceeds) {
  LawBench b = bench();
  b.integrate(0.0); // fills the batch
  const double c = b.law->assess(b.batch).wave_speed;
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    LawBench probe = bench();
    const Index p = trial % size;
    Vec<3> n = Vec<3>::Random().normalized();
    const Sym<double> D = to_sym((trial % 2 ? 1.0 : -1.0) * n * n.transpose()), before = probe.stress_of(p);
    const int e = state_column(probe.law->states(), "void_ratio");
    probe.put(p, before, e >= 0 ? probe.state[e][p] : 0.0, D);
    std::vector<double> state;
    for (int s = 0; s < probe.state.components(); ++s) state.push_back(probe.state[s][p]);
    const double density = probe.law->density(state), dt = 1e-7;
    probe.integrate(dt);
    const double stiffness = std::abs(dot(probe.stress_of(p) - before, D)) / dt;
    EXPECT_LE(std::sqrt(stiffness / density), c * (1 + 1e-6));
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryLaw, testing::ValuesIn(every_law()),
                         [](const auto& tested) { return tested.param.label; });

} // namespace
} // namespace riedel::test
