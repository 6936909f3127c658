/// The stress filter: what the nodes resolve is kept up to rounding errors, the rest decays at the given rate. See
/// docs/theory/stress_filter.md.
#include "apps/biaxial/band.hpp"
#include "apps/biaxial/record.hpp"
#include "apps/element/drivers.hpp"
#include "apps/element/keys.hpp"
#include "core/step/locate.hpp"
#include "core/step/smoothing.hpp"
#include "core/step/stress_filter.hpp"
#include "support/schemes.hpp"
#include "temporary_folder.hpp"
#include "verification/biaxial.hpp"
#include "verification/transfers.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

constexpr StressFilter filter{.stress_rate = 100.0, .volume_rate = 10.0, .order = 12, .steps_between = 2};
constexpr double dt = 1e-4;

/// Points near a lattice, at rest, ready for the filter.
template <int Dim>
Simulation<Dim> shaken(const std::string& scheme_name, Counts<Dim> cells, const StressFilter& with = filter) {
  State<Dim> state = shaken_block<Dim>(cells);
  state.bodies[0].points.velocity.fill(0, 0.0);
  Model<Dim> model = model_with<Dim>(scheme_name);
  model.stress_filter = with;
  Simulation<Dim> simulation(std::move(model), std::move(state));
  locate_points(simulation.state(), simulation.model());
  return simulation;
}

template <int Dim>
Points<Dim>& points_of(Simulation<Dim>& simulation) {
  return simulation.state().bodies[0].points;
}

/// Sets component c of every point's stress.
template <int Dim, class Field>
void set_stress(Points<Dim>& points, const Field& field) {
  for (Index p = 0; p < points.size(); ++p)
    for (int c = 0; c < 6; ++c) points.stress[c][p] = field(points.position_of(p), c);
}

class StressFilterTest : public TransferTest {};

std::vector<std::string> served_schemes() {
  std::vector<std::string> names = scheme_names();
  std::erase_if(names, [](const std::string& name) { return !scheme<2>(name)->gradients_follow_weights(); });
  return names;
}

template <int Dim>
void expect_linear_fields_to_stay(const std::string& name) {
  Simulation<Dim> simulation = shaken<Dim>(name, few_cells<Dim>());
  Points<Dim>& points = points_of(simulation);
  const auto linear = [](const Vec<Dim>& x, int c) {
    return -1e5 * (c + 1) + 3e5 * x[0] / h - (c - 2) * 2e5 * x[1] / h;
  };
  set_stress(points, linear);
  for (int i = 0; i < 20; ++i) filter_stresses(simulation.state(), simulation.model(), dt);
  for (Index p = 0; p < points.size(); ++p)
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(points.stress[c][p], linear(points.position_of(p), c), 1e-10 * 1e6) << "component " << c;
}

TEST_P(StressFilterTest, LeavesALinearFieldAsItIsUpToTheEdges) {
  expect_linear_fields_to_stay<2>(GetParam());
  expect_linear_fields_to_stay<3>(GetParam());
}

/// One point per cell, in its centre, with alternating signs as on a chess-board: at every node they cancel.
TEST_P(StressFilterTest, LetsFadeWhatAlternatesFromPointToPointAtItsRate) {
  State<2> state = elastic_state<2>(
      {24, 24}, h, 1, 5, [](const Vec<2>&) { return true; }, soft);
  Model<2> model = model_with<2>(GetParam());
  model.stress_filter = filter;
  model.stress_filter.order = 2;
  Simulation<2> simulation(std::move(model), std::move(state));
  locate_points(simulation.state(), simulation.model());
  Points<2>& points = points_of(simulation);
  const auto sign = [](const Vec<2>& x) {
    return static_cast<int>(std::floor(x[0] / h) + std::floor(x[1] / h)) % 2 == 0 ? 1.0 : -1.0;
  };
  set_stress(points, [&](const Vec<2>& x, int) { return 1e3 * sign(x); });
  for (Index p = 0; p < points.size(); ++p) points.volume[0][p] *= std::exp(1e-3 * sign(points.position_of(p)));
  constexpr int times = 10;
  filter_stresses(simulation.state(), simulation.model(), dt);
  const Vec<2> middle(12.2 * h, 12.2 * h);
  Index p = 0;
  while ((points.position_of(p) - middle).norm() > 0.5 * h) ++p;
  EXPECT_NEAR(points.expansion[0][p], -filter.volume_rate * 1e-3 * sign(points.position_of(p)),
              2e-3 * 1e-2); // volumes are weights as well
  for (int i = 1; i < times; ++i) filter_stresses(simulation.state(), simulation.model(), dt);
  const double left = std::exp(-filter.stress_rate * filter.steps_between * dt * times);
  for (int c = 0; c < 6; ++c)
    EXPECT_NEAR(points.stress[c][p] * sign(points.position_of(p)), 1e3 * left, 0.01 * 1e3) << "component " << c;
}

/// (1 − s)^12 of a wave of 12 cells is below a thousandth for every scheme.
TEST_P(StressFilterTest, LeavesWavesThatTheGridResolves) {
  State<2> state = elastic_state<2>(
      {48, 24}, h, 1, 5, [](const Vec<2>&) { return true; }, soft);
  Model<2> model = model_with<2>(GetParam());
  model.stress_filter = filter;
  Simulation<2> simulation(std::move(model), std::move(state));
  locate_points(simulation.state(), simulation.model());
  Points<2>& points = points_of(simulation);
  const auto wave = [](const Vec<2>& x, int) { return 1e3 * std::sin(2.0 * std::numbers::pi * x[0] / (12.0 * h)); };
  set_stress(points, wave);
  filter_stresses(simulation.state(), simulation.model(), dt);
  const double share = -std::expm1(-filter.stress_rate * filter.steps_between * dt);
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2> x = points.position_of(p);
    if (std::abs(x[0] - 24.0 * h) > 10.0 * h || std::abs(x[1] - 12.0 * h) > 2.0 * h) continue; // near an edge
    EXPECT_NEAR(points.stress[0][p], wave(x, 0), 1e-2 * share * 1e3);
  }
}

template <int Dim>
double product(const Body<Dim>& body, const FieldRows& a, const FieldRows& b) {
  double sum = 0.0;
  for (Index p = 0; p < body.points.size(); ++p) sum += body.points.volume[0][p] * a[p].lanes[0] * b[p].lanes[0];
  return sum;
}

/// ⟨b, r a⟩ = ⟨r b, a⟩ and 0 ≤ ⟨a, r a⟩ ≤ ⟨a, a⟩ in Σ V a b: so filtering never increases Σ V σ², whatever the
/// positions.
template <int Dim>
void expect_a_self_adjoint_contraction(const std::string& name) {
  Simulation<Dim> simulation = shaken<Dim>(name, few_cells<Dim>());
  Body<Dim>& body = simulation.state().bodies[0];
  body.stencils.keep_for_this_step(*simulation.model().scheme, simulation.state().grid, body.points,
                                   simulation.state().clock);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  FieldRows a = body.fields, b = body.fields;
  for (Index p = 0; p < body.points.size(); ++p) {
    a[p] = ShortVector<8>(between(random));
    b[p] = ShortVector<8>(between(random));
    body.points.volume[0][p] *= 1.0 + 0.3 * between(random);
  }
  const auto rest = [&](const FieldRows& of) {
    body.fields = of;
    subtract_linear(simulation.state(), body);
    subtract_smooth(simulation.state(), simulation.model(), body, 3);
    subtract_linear(simulation.state(), body);
    return body.fields;
  };
  const FieldRows ra = rest(a), rb = rest(b);
  const double aa = product(body, a, a);
  EXPECT_NEAR(product(body, b, ra), product(body, rb, a), 1e-12 * aa);
  EXPECT_GE(product(body, a, ra), -1e-12 * aa);
  EXPECT_LE(product(body, a, ra), (1.0 + 1e-12) * aa);
  EXPECT_GT(product(body, a, ra), 0.01 * aa) << "nothing is out of sight of the nodes";
}

TEST_P(StressFilterTest, IsSelfAdjointAndNeverAdds) {
  expect_a_self_adjoint_contraction<2>(GetParam());
  expect_a_self_adjoint_contraction<3>(GetParam());
}

TEST_P(StressFilterTest, GivesNoStressToPointsThatCarryNone) {
  Simulation<2> simulation = shaken<2>(GetParam(), {4, 4});
  Points<2>& points = points_of(simulation);
  set_stress(points, [](const Vec<2>& x, int c) { return x[0] < h ? 0.0 : -1e4 * (c + 1) * (1.0 + x[1] * x[1]); });
  for (int i = 0; i < 5; ++i) filter_stresses(simulation.state(), simulation.model(), dt);
  for (Index p = 0; p < points.size(); ++p)
    for (int c = 0; c < 6 && points.position[0][p] < h; ++c) EXPECT_EQ(points.stress[c][p], 0.0);
}

/// In every order and transfer: a vibrating block keeps its momentum, stays finite and keeps moving.
TEST_P(StressFilterTest, KeepsMomentumInEveryOrderAndTransfer) {
  for (const Transfer& chosen : {flip, apic, tpic, xpic2})
    for (const StepOrder<2>& order : orders_of_step<2>) {
      const bool rough = chosen.name == "tpic" || order.step == StepFunction<2>(usl_step<2>);
      if (!offers(chosen) || (rough && !traits(GetParam()).continuous_gradients)) continue;
      Model<2> model = model_with<2>(GetParam(), chosen, order.step);
      model.stress_filter = {.stress_rate = 500.0, .volume_rate = 50.0, .order = 6, .steps_between = 3};
      model.cfl = 0.2;
      Simulation<2> simulation(std::move(model), shaken_block<2>({4, 4}));
      const auto momentum = [&] {
        const Points<2>& points = points_of(simulation);
        Vec<2> sum = Vec<2>::Zero();
        for (Index p = 0; p < points.size(); ++p) sum += points.mass[0][p] * points.velocity_of(p);
        return sum;
      };
      const Vec<2> start = momentum();
      const double scale = density * 16 * h * h;
      for (int i = 0; i < 30; ++i) simulation.step();
      EXPECT_LT((momentum() - start).norm(), 1e-12 * scale) << chosen.label << ", " << order.name;
      EXPECT_NE(points_of(simulation).stress[0][0], 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, StressFilterTest, testing::ValuesIn(served_schemes()),
                         [](const auto& test) { return test.param; });

/// Stresses of plane strain compression of a specimen of cells whose nodes move in proportion.
std::vector<double> stresses(const std::string& test, const std::string& rate) {
  CaseFile file = CaseFile::empty();
  for (const std::string& setting :
       {"test=" + test, std::string("driver.kind=mpm"), std::string("grid.cells=3"), "time.stress_filter=" + rate,
        std::string("loading.final_strain=0.01"), std::string("loading.speed=0.05")})
    file.override_with(setting);
  const ElementCase given(element_case(file, catalogue()).values);
  const ElementWatch watch{.at_row = [](const ElementRow&, const MaterialPoint&) {}, .stop = [] { return false; }};
  std::vector<double> all;
  for (const ElementRow& row : element_driver(given).run(given, catalogue(), watch).rows) all.push_back(row.sigma[0]);
  return all;
}

TEST(StressFilter, DoesNotTouchAHomogeneousSpecimen) {
  for (const std::string test : {"biaxial", "triaxial"}) {
    const std::vector<double> with = stresses(test, "1e4"), without = stresses(test, "0");
    ASSERT_EQ(with.size(), without.size());
    EXPECT_GT(with.back(), 1.5 * with.front()) << "nothing has happened";
    for (std::size_t i = 0; i < with.size(); ++i) EXPECT_NEAR(with[i], without[i], 1e-10 * with[i]) << "row " << i;
  }
}

/// Quality of the stresses in the band, and point-steps without stress, of a coarse biaxial test.
std::pair<StressQuality, std::int64_t> quality_of(const std::vector<std::string>& settings) {
  const BiaxialCase values = biaxial_values(settings);
  const TemporaryFolder folder;
  BiaxialRun<2> run(values, catalogue(), folder.path());
  run.begin();
  run.advance([] { return false; }, {});
  const Frame section = run.section();
  return {measure_quality(section, measure_band(section, values), values), run.simulation().state().report.separated};
}

TEST(StressFilter, LeavesAShearBandWithoutScatterAndWithoutPointsThatCarryNothing) {
  std::vector<std::string> settings{"scheme=cpdi", "grid.cells=[16,56]", "nonlocal.length=2.25e-3", "loading.speed=0.2",
                                    "loading.final_strain=0.05"};
  const auto [with, separated_with] = quality_of(settings);
  settings.push_back("time.stress_filter=0");
  const auto [without, separated_without] = quality_of(settings);
  EXPECT_LT(with.pressure_scatter, 0.04);
  EXPECT_GT(without.pressure_scatter, 0.2);
  EXPECT_EQ(separated_with, 0);
  EXPECT_GT(separated_without, 1000);
  EXPECT_EQ(with.doubt(), "");
  EXPECT_THAT(without.doubt(), testing::HasSubstr("the pressures of neighbouring points in the band differ by "));
}

TEST(StressFilter, IsRefusedWithRatesThatDoNotFit) {
  const auto refusal = [](StressFilter with, const std::string& scheme_name = "gimp") {
    Model<2> model = model_with<2>(scheme_name);
    model.stress_filter = with;
    try {
      const Simulation<2> simulation(std::move(model), shaken_block<2>({4, 4}));
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("no error");
  };
  EXPECT_EQ(refusal({.stress_rate = 10.0, .volume_rate = 1.0}), "no error");
  EXPECT_THAT(refusal({.stress_rate = 10.0, .volume_rate = 2.0}),
              testing::HasSubstr("is over a tenth of that for stresses"));
  EXPECT_THAT(refusal({.stress_rate = 10.0}, "ddmp"), testing::HasSubstr("gradients are not those of its weights"));
  EXPECT_THAT(
      [] {
        (void)biaxial_values({"scheme=ddmp", "time.stress_filter=1e4"});
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("does not go with the scheme \"ddmp\"")));
  EXPECT_NO_THROW((void)biaxial_values({"scheme=ddmp"}));
  EXPECT_THAT(refusal({.stress_rate = 10.0, .order = 0}), testing::HasSubstr("allowed: 1 and more"));
}

} // namespace
} // namespace riedel::test
