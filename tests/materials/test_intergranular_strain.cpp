/// Hypoplastic laws with intergranular strain: against an independent evaluation and integration, and against the
/// stiffness known from theory.
#include "materials/intergranular_strain.hpp"

#include "materials/gudehus_bauer.hpp"
#include "materials/von_wolffersdorff.hpp"
#include "support/csv.hpp"
#include "support/law.hpp"

#include <cstdio>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

constexpr double R = 1e-4, m_R = 5.0, m_T = 2.0; // defaults

template <class Base>
class WithIntergranularStrain : public testing::Test {
protected:
  static Values values() {
    Values all(Base::parameters());
    for (const Key& key : IntergranularStrainParameters::keys()) all.set(key.name, key.default_value);
    return all;
  }
  const Base basic{values()};
  const IntergranularStrain<Base> extended{values()};
  const Sym<double> sigma{{-200e3, -350e3, -150e3, 40e3, -25e3, 15e3}}, D{{-1.0, 0.4, 0.3, 0.2, -0.5, 0.1}};

  static std::array<double, 7> state(const Sym<double>& h) {
    return {0.7, h.m[0], h.m[1], h.m[2], h.m[3], h.m[4], h.m[5]};
  }
  static Sym<double> strain(const std::array<double, 7>& s) { return {{s[1], s[2], s[3], s[4], s[5], s[6]}}; }
  Rate<double, 7> rate(const Sym<double>& h) const {
    return extended.template rate<double>(sigma, state(h), D, norm(D));
  }
  /// Of the basic law: L:D + N d
  Sym<double> basic_rate(double d) const { return basic.template rate<double>(sigma, {0.7}, D, d).stress; }
  /// h of the size ρ along D, and one across it
  Sym<double> along(double rho) const { return (rho * R / norm(D)) * D; }
  Sym<double> across() const {
    const Sym<double> other{{0.3, 0.5, -0.2, 0.7, 0.1, -0.4}}, h = other - (dot(other, D) / dot(D, D)) * D;
    return (R / norm(h)) * h;
  }
  void expect_stress_rate(const Sym<double>& h, const Sym<double>& expected) const {
    EXPECT_LT(norm(rate(h).stress - expected), 1e-12 * norm(expected));
  }
};

using Laws = testing::Types<GudehusBauer, VonWolffersdorff>;
class NameOfLaw {
public:
  template <class Law>
  static std::string GetName(int) {
    return std::string(Law::name);
  }
};
TYPED_TEST_SUITE(WithIntergranularStrain, Laws, NameOfLaw);

TYPED_TEST(WithIntergranularStrain, IsTheBasicLawInLoadingThatGoesOnAndThenKeepsItsStrain) {
  this->expect_stress_rate(this->along(1.0), this->basic_rate(norm(this->D)));
  EXPECT_LT(norm(this->strain(this->rate(this->along(1.0)).state)), 1e-12 * norm(this->D));
}

TYPED_TEST(WithIntergranularStrain, IsStifferByM_RAfterAReversalThanTheLinearPart) {
  this->expect_stress_rate(this->along(-1.0), m_R * this->basic_rate(0.0));
  EXPECT_LT(norm(this->strain(this->rate(this->along(-1.0)).state) - this->D), 1e-12 * norm(this->D));
}

TYPED_TEST(WithIntergranularStrain, IsStifferByM_TAfterATurnBy90DegreesThanTheLinearPart) {
  this->expect_stress_rate(this->across(), m_T * this->basic_rate(0.0));
  EXPECT_LT(norm(this->strain(this->rate(this->across()).state) - this->D), 1e-12 * norm(this->D));
}

TYPED_TEST(WithIntergranularStrain, IsStifferByM_RWhereNoStrainIsRememberedAndNeedsNoDirectionThere) {
  for (const double size : {0.0, 1e-12, 1e-200, 1e-320}) { // of h/R; the last ones have no square
    this->expect_stress_rate(this->along(size), m_R * this->basic_rate(0.0));
    for (const double h_rate : this->rate(this->along(size)).state) EXPECT_TRUE(std::isfinite(h_rate));
  }
}

TYPED_TEST(WithIntergranularStrain, TakesAStrainALittleTooLargeForR_AndBringsItBack) {
  this->expect_stress_rate(this->along(1.01), this->basic_rate(norm(this->D)));
  EXPECT_LT(dot(this->strain(this->rate(this->along(1.01)).state), this->D), 0.0);
}

TYPED_TEST(WithIntergranularStrain, RatesAgreeBetweenPacksAndScalars) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Sym<double>, pack_size> stress, rate, h;
    for (std::size_t k = 0; k < pack_size; ++k) {
      stress[k] = random_stress(random, std::pow(10.0, 1.0 + 0.1 * trial));
      rate[k] = random_rate(random);
      h[k] = k == 2 ? Sym<double>::zero() : 6e-5 * random_rate(random);
    }
    std::array<Pack, 7> state{Pack(0.7)};
    const Sym<Pack> packed_h = packed(h), packed_D = packed(rate);
    std::copy(packed_h.m.begin(), packed_h.m.end(), state.begin() + 1);
    const auto all = this->extended.template rate<Pack>(packed(stress), state, packed_D, norm(packed_D));
    Sym<Pack> all_h;
    std::copy(all.state.begin() + 1, all.state.end(), all_h.m.begin());
    for (std::size_t k = 0; k < pack_size; ++k) {
      const auto alone = this->extended.template rate<double>(stress[k], this->state(h[k]), rate[k], norm(rate[k]));
      EXPECT_LT(norm(unpacked(all.stress)[k] - alone.stress), 1e-12 * norm(alone.stress));
      EXPECT_LT(norm(unpacked(all_h)[k] - this->strain(alone.state)), 1e-12 * norm(rate[k]));
    }
  }
}

/// Evaluated once with M of Niemunis & Herle as a tensor of fourth order, σ° = M_ijkl D_kl.
TYPED_TEST(WithIntergranularStrain, HasTheRateOfAnIndependentEvaluation) {
  const bool first = std::is_same_v<TypeParam, GudehusBauer>;
  const Sym<double> h{{3e-5, -6e-5, 1e-5, 2e-5, -1e-5, 3e-5}}; // ĥ:D < 0
  const Sym<double> turned = first ? Sym<double>{{-181303610.382359, 46964943.64516222, 35286377.87095473,
                                                  32203072.11194183, -80986111.72237992, 12595993.05485674}}
                                   : Sym<double>{{-106491464.8647717, 30915025.65705832, 22291460.03705467,
                                                  18877880.32829405, -48101549.60464583, 7389293.418498756}};
  const Sym<double> loaded = first ? Sym<double>{{-185453606.5076773, 19276271.52994124, 28578376.39732204,
                                                  37647713.92165331, -83868801.31953551, 19319637.53872543}}
                                   : Sym<double>{{-107716637.9466592, 16401320.87242946, 19289611.25438788,
                                                  21924993.88088964, -49695686.26160011, 11324744.82148399}};
  EXPECT_LT(norm(this->rate(h).stress - turned), 1e-10 * norm(turned));
  EXPECT_LT(norm(this->rate(-1.0 * h).stress - loaded), 1e-10 * norm(loaded));
  const Sym<double> h_rate{{-0.8283782113252883, 0.05675642265057648, 0.3572072628915706, 0.3144145257831412,
                            -0.5572072628915706, 0.2716217886747118}};
  EXPECT_LT(norm(this->strain(this->rate(-1.0 * h).state) - h_rate), 1e-10);
  EXPECT_NEAR(this->rate(h).state[0], 1.7 * trace(this->D), 1e-14);
}

std::shared_ptr<const Material> sand(double tolerance = 1e-4) {
  return material("von_wolffersdorff", {{"intergranular_strain", true}, {"tolerance", tolerance}});
}

Sym<double> tensor_in(const Table& table, const std::string& name, const std::string& unit, std::size_t row) {
  Mat<3> a;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      a(i, j) = a(j, i) = table.at(name + std::to_string(i + 1) + std::to_string(j + 1) + unit)[row];
  return to_sym(a);
}

struct Differences {
  double stress = 0.0, strain = 0.0; ///< relative; relative to R
};

/// Isotropic compression, deviatoric cycles, shear across them and cycles of shear. @return the largest differences
Differences follow_cycles(double tolerance, double step) {
  const Table curve = reference("von_wolffersdorff_intergranular_strain_cycles.csv");
  LawBench bench(sand(tolerance), 1);
  bench.put(0, tensor_in(curve, "s", "_Pa", 0), curve.at("e")[0], Sym<double>::zero());
  Differences maximum;
  for (std::size_t row = 1; row < curve.at("e").size(); ++row) {
    const double strain = curve.at("strain")[row] - curve.at("strain")[row - 1];
    const int parts = 1 + static_cast<int>(strain / step);
    bench.put(0, bench.stress_of(0), bench.state[0][0], tensor_in(curve, "D", "", row));
    for (int i = 0; i < parts; ++i) bench.integrate(strain / parts);
    const Sym<double> sigma = tensor_in(curve, "s", "_Pa", row), h = tensor_in(curve, "h", "", row);
    maximum.stress = std::max(maximum.stress, norm(bench.stress_of(0) - sigma) / norm(sigma));
    maximum.strain = std::max(maximum.strain, norm(bench.tensor_of("intergranular_strain", 0) - h) / R);
  }
  std::printf("cycles, tolerance %.0e, steps of %.0e: stress within %.1e, h/R within %.1e; %.0f steps were cut\n",
              tolerance, step, maximum.stress, maximum.strain, double(bench.report.substepped));
  return maximum;
}

TEST(IntergranularStrain, FollowsAnIndependentIntegrationOfCycles) {
  const Differences exact = follow_cycles(1e-7, 1e-6);
  EXPECT_LT(exact.stress, 1e-5);
  EXPECT_LT(exact.strain, 1e-5);
  for (const double step : {1e-7, 1e-6, 1e-5, 1e-4}) { // with the default tolerance
    const Differences usual = follow_cycles(1e-4, step);
    EXPECT_LT(usual.stress, 1e-3);
    EXPECT_LT(usual.strain, 1e-3);
  }
}

TEST(IntergranularStrain, IsForgottenWhereTheGrainsPart) {
  LawBench bench(sand(), 1);
  bench.put(0, -1e3 * Sym<double>::identity(), 0.7, diagonal(1, 1, 1));
  bench.put_tensor("intergranular_strain", 0, diagonal(5e-5, 0, 0));
  for (int step = 0; step < 100; ++step) bench.integrate(1e-5);
  EXPECT_GT(bench.state[bench.column("separation")][0], 0.0);
  EXPECT_EQ(norm(bench.tensor_of("intergranular_strain", 0)), 0.0);
  EXPECT_EQ(bench.report.failures, 0);
}

TEST(IntergranularStrain, TakesNothingAveraged) {
  EXPECT_TRUE(sand()->nonlocal_variables().empty());
  EXPECT_FALSE(material("von_wolffersdorff")->nonlocal_variables().empty());
  LawBench local(sand(), 9), averaged(sand(), 9);
  for (LawBench* bench : {&local, &averaged})
    for (Index p = 0; p < 9; ++p) bench->put(p, -1e5 * diagonal(1, 1.5, 1), 0.7, diagonal(0.2, -1, 0.3));
  averaged.averaged.assign(16, 5.0);
  local.integrate(1e-5);
  averaged.integrate(1e-5);
  for (Index p = 0; p < 9; ++p) EXPECT_EQ(norm(local.stress_of(p) - averaged.stress_of(p)), 0.0);
}

TEST(IntergranularStrain, IsATensorAmongTheStateVariables) {
  const auto law = sand();
  const auto states = law->states();
  ASSERT_EQ(states.size(), 3);
  EXPECT_EQ(states[0].name, "void_ratio");
  EXPECT_EQ(states[1].name, "intergranular_strain");
  EXPECT_EQ(states[1].components, 6);
  EXPECT_EQ(states[2].name, "separation");
  EXPECT_EQ(material("von_wolffersdorff")->states().size(), 2);
}

TEST(IntergranularStrain, RefusesATurnThatStiffensMoreThanAReversalEvenWhereSwitchedOff) {
  for (const bool on : {false, true}) {
    try {
      material("gudehus_bauer", {{"intergranular_strain", on}, {"m_T", 6.0}});
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "gudehus_bauer: m_T = 6.0 is out of range; allowed: [1, m_R = 5.0]");
    }
  }
}

} // namespace
} // namespace riedel::test
