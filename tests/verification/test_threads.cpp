/// The number of threads changes no bit of any point's fields, whatever the search, the order of the step, the scheme
/// and the dimension.
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"
#include "support/fields_by_id.hpp"
#include "verification/biaxial.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

/// All fields of all points, by id, and the run's forces and energies.
template <int Dim>
std::vector<double> everything(Simulation<Dim>& simulation) {
  std::vector<double> all = fields_by_id(simulation);
  for (const auto& condition : simulation.model().conditions) all.push_back(condition->report().reaction);
  const Energies energies = simulation.energies();
  all.insert(all.end(), {energies.kinetic, energies.internal, energies.external, simulation.time_step()});
  return all;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::vector<double> after_steps(const BiaxialCase& values, int threads, int steps) {
  omp_set_num_threads(threads);
  Simulation<2> simulation = make_biaxial(values, catalogue());
  for (int i = 0; i < steps; ++i) simulation.step();
  const Points<2>& points = simulation.state().bodies[0].points;
  EXPECT_GT(points.shear_strain[0][0], 0.0) << "nothing has happened";
  EXPECT_GT(simulation.state().bodies[0].slabs.count(), 3) << "nothing to share";
  return everything(simulation);
}

/// The ramp is short so that all points are in motion at once.
BiaxialCase lively(const std::vector<std::string>& more) {
  std::vector<std::string> settings{"loading.ramp_time=1e-4"};
  settings.insert(settings.end(), more.begin(), more.end());
  return coarse_values(settings);
}

TEST(Threads, ChangeNoBitOfTheBiaxialTestWithEitherSearch) {
  const std::vector<double> alone =
      after_steps(lively({"nonlocal.search=" + catalogue().in_2d.searches.names().front()}), 1, 300);
  for (const std::string& search : catalogue().in_2d.searches.names())
    for (const int threads : {1, 2, 3, 4})
      EXPECT_TRUE(same_bits(after_steps(lively({"nonlocal.search=" + search}), threads, 300), alone))
          << search << ", " << threads << " threads";
}

/// As in a run that searches for the fastest number.
TEST(Threads, ChangeNoBitWhenTheirNumberChangesFromStepToStep) {
  const std::vector<double> alone = after_steps(lively({}), 1, 300);
  Simulation<2> simulation = make_biaxial(lively({}), catalogue());
  for (int i = 0; i < 300; ++i) {
    omp_set_num_threads(1 + i % 4);
    simulation.step();
  }
  EXPECT_TRUE(same_bits(everything(simulation), alone));
}

TEST(Threads, ChangeNoBitOfTheBiaxialTestWithAnyAverager) {
  for (const std::string& averager : catalogue().in_2d.averagers.names()) {
    const BiaxialCase values = lively({"nonlocal.averager=" + averager});
    const std::vector<double> alone = after_steps(values, 1, 100);
    for (const int threads : {2, 3}) EXPECT_TRUE(same_bits(after_steps(values, threads, 100), alone)) << averager;
  }
}

/// Ends of a run of an elastic block, its stencils in blocks and kept.
std::array<std::vector<double>, 2> ends_of_both_ways(const std::string& name, const std::string& chosen) {
  std::array<std::vector<double>, 2> ends;
  for (const bool keep : {false, true}) {
    State<2> state = elastic_state<2>({6, 20}, 0.1, 2, 6, [](const Vec<2>&) { return true; });
    Points<2>& points = state.bodies[0].points;
    for (Index p = 0; p < points.size(); ++p) points.velocity[1][p] = std::sin(9.0 * points.position[0][p]);
    Model<2> model = model_with<2>(name);
    model.transfer = transfer<2>(chosen);
    model.keep_stencils = keep;
    Simulation<2> simulation(std::move(model), std::move(state));
    for (int i = 0; i < 40; ++i) simulation.step();
    EXPECT_EQ(simulation.state().bodies[0].stencils.keeps(), keep);
    ends[keep] = everything(simulation);
  }
  return ends;
}

/// Block by block in every sweep, or once for the whole step.
TEST(Stencils, GiveTheSameBitsKeptAsInBlocks) {
  for (const std::string& name : scheme_names())
    for (const std::string& chosen : transfer_names()) {
      if (!goes_with(chosen, name)) continue;
      const auto [in_blocks, kept] = ends_of_both_ways(name, chosen);
      EXPECT_TRUE(same_bits(in_blocks, kept)) << name << ", " << chosen;
    }
}

TEST(Threads, ChangeNoBitInAnyOrderOfTheStep) {
  for (const std::string order : {"musl", "usl", "usf"}) {
    const BiaxialCase values = lively({"time.order=" + order, "nonlocal.length=0.0"});
    EXPECT_TRUE(same_bits(after_steps(values, 1, 60), after_steps(values, 2, 60))) << order;
    EXPECT_TRUE(same_bits(after_steps(values, 1, 60), after_steps(values, 4, 60))) << order;
  }
}

TEST(Threads, ChangeNoBitInAnyTransfer) {
  for (const std::string& transfer : transfer_names())
    for (const std::string order : {"musl", "usl", "usf"}) {
      const BiaxialCase values = lively({"time.transfer=" + transfer, "time.order=" + order, "nonlocal.length=0.0"});
      EXPECT_TRUE(same_bits(after_steps(values, 1, 40), after_steps(values, 4, 40))) << transfer << ", " << order;
    }
}

TEST(Threads, ChangeNoBitInAnyScheme) {
  for (const std::string& name : scheme_names()) {
    const BiaxialCase values = lively({"scheme=" + name, "specimen.points_per_cell=2", "nonlocal.length=0.0"});
    EXPECT_TRUE(same_bits(after_steps(values, 1, 40), after_steps(values, 4, 40))) << name;
  }
}

TEST(Threads, ChangeNoBitWithRigidPlatensAndPressureOnPoints) {
  const BiaxialCase values = lively({"loading.platen=rigid_points", "loading.lateral=points"});
  EXPECT_TRUE(same_bits(after_steps(values, 1, 60), after_steps(values, 4, 60)));
}

TEST(Threads, ChangeNoBitWithFBar) {
  for (const std::string order : {"musl", "usf"}) {
    const BiaxialCase values = lively({"time.locking=f_bar", "time.order=" + order, "nonlocal.length=0.0"});
    const std::vector<double> alone = after_steps(values, 1, 100);
    for (const int threads : {2, 3, 4}) EXPECT_TRUE(same_bits(after_steps(values, threads, 100), alone)) << order;
  }
}

/// A tall elastic block, twisted and stretched at the start.
std::vector<double> wrung_block(const std::string& scheme_name, int threads, const std::string& chosen = "flip",
                                Locking locking = Locking::none) {
  omp_set_num_threads(threads);
  State<3> state = elastic_state<3>({3, 3, 24}, 0.1, 1, 5, [](const Vec<3>&) { return true; });
  Points<3>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    const double turn = 5.0 * points.position[2][p];
    points.velocity[0][p] = -turn * points.position[1][p];
    points.velocity[1][p] = turn * points.position[0][p];
    points.velocity[2][p] = 3.0 * points.position[2][p];
  }
  Model<3> model = model_with<3>(scheme_name);
  model.transfer = transfer<3>(chosen);
  model.locking = locking;
  Simulation<3> simulation(std::move(model), std::move(state));
  for (int i = 0; i < 50; ++i) simulation.step();
  EXPECT_GT(simulation.state().bodies[0].slabs.count(), 2) << "nothing to share";
  return everything(simulation);
}

TEST(Threads, ChangeNoBitInThreeDimensions) {
  for (const std::string& chosen : transfer_names()) {
    const std::vector<double> alone = wrung_block("cpdi", 1, chosen);
    EXPECT_TRUE(same_bits(wrung_block("cpdi", 2, chosen), alone)) << chosen;
    EXPECT_TRUE(same_bits(wrung_block("cpdi", 4, chosen), alone)) << chosen;
  }
  for (const std::string scheme_name : {"cpdi2", "ddmp"}) {
    const std::vector<double> alone = wrung_block(scheme_name, 1);
    EXPECT_TRUE(same_bits(wrung_block(scheme_name, 2), alone)) << scheme_name;
    EXPECT_TRUE(same_bits(wrung_block(scheme_name, 4), alone)) << scheme_name;
  }
  const std::vector<double> alone = wrung_block("gimp", 1, "flip", Locking::f_bar);
  EXPECT_TRUE(same_bits(wrung_block("gimp", 4, "flip", Locking::f_bar), alone)) << "F-bar";
}

} // namespace
} // namespace riedel::test
