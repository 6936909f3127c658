/// What every registered boundary condition must satisfy, in two and three dimensions.
#include "core/step/boundary.hpp"
#include "support/problems.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

constexpr double dt = 0.01, tolerance = 1e-11;

std::vector<std::string> boundary_names() { return catalogue().in_2d.boundaries.names(); }

/// Values for a condition by name; a key that it does not have is left out.
template <int Dim>
Boundary<Dim> boundary(const std::string& kind, const NodeBox<Dim>& place, const std::map<std::string, Value>& with) {
  const auto& entry = catalogue().in<Dim>().boundaries.find(kind);
  Values values(entry.description.parameters);
  for (const auto& [key, value] : with)
    if (values.has(key)) values.set(key, value);
  return entry.make("tested", place, values);
}

/// What makes a condition do different things.
const std::vector<std::map<std::string, Value>> uses{
    {},
    {{"velocity", std::vector<double>{-0.7}}},
    {{"velocity", std::vector<double>{0.0, 3.0}}, {"times", std::vector<double>{0.0, 1.0}}, {"separates", false}},
    {{"free", true}, {"friction", 5.0}}};

/// Nodes with various masses, velocities and accelerations, one in seven without any; the condition acts on a box
/// inside the grid.
template <int Dim>
struct Shaken {
  State<Dim> state;
  Model<Dim> model;
  AlignedVector<NodeMotion<Dim>> before; ///< before the momentum balance

  Shaken(const std::string& kind, const std::map<std::string, Value>& with, bool at_rest = false) {
    Counts<Dim> cells;
    cells.fill(6);
    state.grid = grid_of<Dim>(cells, 0.5, 0);
    state.nodes.resize(state.grid.node_count());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (Index i = 0; i < state.nodes.size(); ++i) {
      NodeSums<Dim>& sums = state.nodes.sums[i];
      sums.mass = i % 7 == 3 ? 0.0 : 1.5 + unit(random);
      for (int a = 0; a < Dim && !at_rest && sums.mass > 0.0; ++a) {
        state.nodes.motion[i].velocity[a] = unit(random);
        state.nodes.motion[i].acceleration[a] = 50.0 * unit(random);
      }
    }
    NodeBox<Dim> place{.axis = 1};
    place.first.fill(1);
    place.last.fill(4);
    place.last[1] = 2;
    model.scheme = scheme<Dim>("linear");
    model.conditions.push_back(boundary<Dim>(kind, place, with));
    bind_boundaries(state, model);
    follow_boundaries(state, model);
    before = state.nodes.motion;
    remember_velocities(state, model);
    for (Index i = 0; i < state.nodes.size(); ++i)
      state.nodes.motion[i].velocity += dt * state.nodes.motion[i].acceleration;
    state.node_power = {.start = 3.0, .end = power()};
  }

  [[nodiscard]] const BoundaryCondition<Dim>& condition() const { return *model.conditions.front(); }
  /// Σ m a·v
  [[nodiscard]] double power() const {
    double sum = 0.0;
    for (Index i = 0; i < state.nodes.size(); ++i)
      sum += state.nodes.sums[i].mass * state.nodes.motion[i].acceleration.dot(state.nodes.motion[i].velocity);
    return sum;
  }
  [[nodiscard]] bool is_of_condition(Index i) const {
    return std::ranges::find(condition().nodes(), i) != condition().nodes().end();
  }
};

template <class Motions>
bool same_bits(const Motions& a, const Motions& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

template <int Dim>
void force_is_the_change_of_momentum(const std::string& kind) {
  bool acts = false;
  for (const auto& with : uses) {
    Shaken<Dim> nodes(kind, with);
    const AlignedVector<NodeMotion<Dim>> free = nodes.state.nodes.motion;
    apply_boundaries(nodes.state, nodes.model, dt);
    Vec<Dim> change = Vec<Dim>::Zero();
    for (Index i = 0; i < nodes.state.nodes.size(); ++i) {
      const NodeMotion<Dim>& now = nodes.state.nodes.motion[i];
      const Vec<Dim> v = now.velocity - free[i].velocity;
      change += nodes.state.nodes.sums[i].mass * v;
      EXPECT_LT((dt * (now.acceleration - free[i].acceleration) - v).norm(), tolerance) << "node " << i;
      EXPECT_TRUE(nodes.is_of_condition(i) || v.norm() == 0.0) << "node " << i;
      acts = acts || v.norm() > 0.0;
    }
    EXPECT_LT((dt * nodes.condition().report().force - change).norm(), tolerance);
  }
  EXPECT_TRUE(acts);
}

template <int Dim>
void work_is_accounted_for(const std::string& kind) {
  for (const auto& with : uses) {
    Shaken<Dim> nodes(kind, with);
    apply_boundaries(nodes.state, nodes.model, dt);
    const BoundaryReport<Dim>& report = nodes.condition().report();
    EXPECT_NEAR(report.work, report.reaction * report.speed * dt - report.dissipated, tolerance);
    EXPECT_EQ(nodes.state.boundary_work, report.work);
    EXPECT_EQ(nodes.state.boundary_loss, report.dissipated);
    EXPECT_NEAR(nodes.state.node_power.end, nodes.power(), 1e-9) << "of all forces with the velocities now";
    apply_boundary_velocities(nodes.state, nodes.model, dt);
    EXPECT_NEAR(nodes.state.node_power.end, nodes.power(), 1e-9) << "after velocities alone";
  }
}

/// However the velocities change from before to after, start and end share the work of the force.
template <int Dim>
void power_at_the_start_is_with_the_velocities_before(const std::string& kind) {
  Shaken<Dim> nodes(kind, {}, true);
  for (Index i = 0; i < nodes.state.nodes.size(); ++i) nodes.state.nodes.motion[i].velocity[1] = -0.2;
  apply_boundaries(nodes.state, nodes.model, dt); // what was at rest, and is about to move
  EXPECT_EQ(nodes.state.node_power.start, 3.0);
}

template <int Dim>
void velocities_alone_set_twice_are_those_set_once(const std::string& kind) {
  for (const auto& with : uses) {
    Shaken<Dim> nodes(kind, with);
    apply_boundaries(nodes.state, nodes.model, dt);
    for (Index i = 0; i < nodes.state.nodes.size(); ++i) // a remap
      if (nodes.state.nodes.sums[i].mass > 0.0)
        for (int a = 0; a < Dim; ++a) nodes.state.nodes.motion[i].velocity[a] += 0.1 * std::sin(3.0 * i + a);
    apply_boundary_velocities(nodes.state, nodes.model, dt);
    AlignedVector<NodeMotion<Dim>> once = nodes.state.nodes.motion;
    apply_boundary_velocities(nodes.state, nodes.model, dt);
    for (Index i = 0; i < nodes.state.nodes.size(); ++i) // a common velocity is a mean of equal numbers
      EXPECT_LT((nodes.state.nodes.motion[i].velocity - once[i].velocity).norm(), 1e-14) << "node " << i;
  }
}

template <int Dim>
void what_is_at_rest_stays_so(const std::string& kind) {
  Shaken<Dim> nodes(kind, {}, true);
  const AlignedVector<NodeMotion<Dim>> rest = nodes.state.nodes.motion;
  apply_boundaries(nodes.state, nodes.model, dt);
  apply_boundary_velocities(nodes.state, nodes.model, dt);
  for (Index i = 0; i < nodes.state.nodes.size(); ++i) {
    EXPECT_EQ(nodes.state.nodes.motion[i].velocity.norm(), 0.0);
    EXPECT_EQ(nodes.state.nodes.motion[i].acceleration.norm(), 0.0);
  }
  EXPECT_EQ(nodes.condition().report().force.norm(), 0.0);
}

/// A condition that lets nothing through from side to side is a wall.
template <int Dim>
void walls_are_told(const std::string& kind) {
  for (const Behind behind : {Behind::lower, Behind::upper}) {
    Shaken<Dim> nodes(kind, {}, true);
    const Grid<Dim>& grid = nodes.state.grid;
    NodeBox<Dim> place{.axis = 1, .behind = behind};
    for (std::size_t a = 0; a < Dim; ++a) place.last[a] = grid.nodes[a] - 1;
    (behind == Behind::lower ? place.last : place.first)[1] = 3;
    nodes.model.conditions.front() = boundary<Dim>(kind, place, {});
    bind_boundaries(nodes.state, nodes.model);
    for (Index i = 0; i < nodes.state.nodes.size(); ++i)
      nodes.state.nodes.motion[i].velocity[1] = behind == Behind::lower ? -1.0 : 1.0;
    apply_boundaries(nodes.state, nodes.model, dt);
    bool let_through = false;
    for (Index i = 0; i < nodes.state.nodes.size(); ++i)
      if (grid.index(i)[1] == 3) let_through = let_through || nodes.state.nodes.motion[i].velocity[1] != 0.0;
    const Walls& told = grid.walls[1];
    EXPECT_EQ(told.first, !let_through && behind == Behind::lower ? 3 : Walls::none_below);
    EXPECT_EQ(told.last, !let_through && behind == Behind::upper ? 3 : Walls::none_above);
  }
}

/// Velocities of a block that falls on a condition and slides, after some steps.
template <int Dim>
std::vector<double> after_steps(const std::string& kind, int threads) {
  omp_set_num_threads(threads);
  Counts<Dim> cells;
  cells.fill(Dim == 2 ? 16 : 6);
  State<Dim> state = elastic_state<Dim>(cells, 0.1, 2, 4, [](const Vec<Dim>&) { return true; });
  state.bodies[0].points.velocity.fill(0, 2.0);
  state.bodies[0].points.velocity.fill(1, -5.0);
  NodeBox<Dim> place{.axis = 1};
  for (std::size_t a = 0; a < Dim; ++a) {
    place.first[a] = 2;
    place.last[a] = state.grid.nodes[a] - 3;
  }
  place.last[1] = 4;
  Model<Dim> model = model_with<Dim>("gimp");
  model.conditions.push_back(boundary<Dim>(kind, place, {{"friction", 0.4}}));
  Simulation<Dim> simulation(std::move(model), std::move(state));
  for (int i = 0; i < 30; ++i) simulation.step();
  omp_set_num_threads(1);
  const Points<Dim>& points = simulation.state().bodies[0].points;
  const BoundaryReport<Dim>& report = simulation.boundary("tested").report();
  std::vector<double> all{report.reaction, report.work, report.dissipated, simulation.energies().external,
                          simulation.energies().transfer};
  EXPECT_NE(report.reaction, 0.0) << "they have not met";
  for (int a = 0; a < Dim; ++a)
    for (Index p = 0; p < points.size(); ++p) all.push_back(points.velocity[a][p]);
  return all;
}

class EveryBoundary : public testing::TestWithParam<std::string> {};

TEST_P(EveryBoundary, GivesItsNodesAloneTheForceThatItReports) {
  force_is_the_change_of_momentum<2>(GetParam());
  force_is_the_change_of_momentum<3>(GetParam());
}
TEST_P(EveryBoundary, AccountsForItsWorkAndForThePowerOfAllForces) {
  work_is_accounted_for<2>(GetParam());
  work_is_accounted_for<3>(GetParam());
}
TEST_P(EveryBoundary, TakesNoPowerFromVelocitiesThatWereZeroBefore) {
  power_at_the_start_is_with_the_velocities_before<2>(GetParam());
  power_at_the_start_is_with_the_velocities_before<3>(GetParam());
}
TEST_P(EveryBoundary, SetsVelocitiesTwiceAsOnce) {
  velocities_alone_set_twice_are_those_set_once<2>(GetParam());
  velocities_alone_set_twice_are_those_set_once<3>(GetParam());
}
TEST_P(EveryBoundary, LeavesWhatIsAtRestAtRest) {
  what_is_at_rest_stays_so<2>(GetParam());
  what_is_at_rest_stays_so<3>(GetParam());
}
TEST_P(EveryBoundary, IsAWallToTheSchemesIfItLetsNothingThrough) {
  walls_are_told<2>(GetParam());
  walls_are_told<3>(GetParam());
}
TEST_P(EveryBoundary, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const int threads : {2, 4}) {
    EXPECT_TRUE(same_bits(after_steps<2>(GetParam(), threads), after_steps<2>(GetParam(), 1))) << threads;
    EXPECT_TRUE(same_bits(after_steps<3>(GetParam(), threads), after_steps<3>(GetParam(), 1))) << threads;
  }
}
TEST_P(EveryBoundary, KeepsTheNameOfItsUserAndRefusesAnotherKind) {
  EXPECT_EQ(Shaken<2>(GetParam(), {}).condition().name(), "tested");
  EXPECT_THROW((void)boundary<2>(GetParam() + "_", {}, {}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryBoundary, testing::ValuesIn(boundary_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
