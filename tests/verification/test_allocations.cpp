/// A step allocates nothing on the heap. The operators below serve this whole program and count only on request.
#include "verification/biaxial.hpp"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>
#include <omp.h>

namespace {
std::atomic<bool> counting = false;
std::atomic<long> allocations = 0;

void* take(std::size_t size, std::size_t alignment) {
  if (counting) ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
} // namespace

[[gnu::noinline]] void* operator new(std::size_t size) { return take(size, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return take(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size,
                                     const std::nothrow_t&) noexcept { // of the standard library's sorts
  try {
    return take(size, alignof(std::max_align_t));
  } catch (const std::bad_alloc&) { return nullptr; }
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace riedel::test {
namespace {

/// Allocations in 100 steps, after some that may still enlarge working space.
template <int Dim>
long allocations_in_steps(Simulation<Dim>& simulation) {
  allocations = 0;
  counting = true;
  for (int i = 0; i < 100; ++i) simulation.step();
  counting = false;
  return allocations;
}

template <int Dim>
Simulation<Dim> warm(Simulation<Dim> simulation) {
  omp_set_num_threads(1);
  for (int i = 0; i < 5; ++i) simulation.step();
  return simulation;
}

std::int64_t searches(const Simulation<2>& simulation) {
  const auto& averager = simulation.state().bodies[0].averager;
  return averager ? averager->searches() : 0;
}

class AllocationTest : public testing::TestWithParam<std::string> {};

TEST_P(AllocationTest, AreNoneInAStepOfTheLocalModel) {
  for (const std::string order : {"musl", "usl", "usf"}) {
    const BiaxialCase values = coarse_values({"scheme=" + GetParam(), "time.order=" + order, "nonlocal.length=0.0"});
    Simulation<2> simulation = warm(make_biaxial(values, catalogue()));
    EXPECT_EQ(allocations_in_steps(simulation), 0) << order;
  }
}

TEST_P(AllocationTest, AreNoneInAStepWithFBar) {
  for (const std::string order : {"musl", "usf"}) {
    const BiaxialCase values =
        coarse_values({"scheme=" + GetParam(), "time.order=" + order, "time.locking=f_bar", "nonlocal.length=0.0"});
    Simulation<2> simulation = warm(make_biaxial(values, catalogue()));
    EXPECT_EQ(allocations_in_steps(simulation), 0) << order;
  }
}

TEST_P(AllocationTest, AreNoneInAStepOfAnyTransfer) {
  for (const std::string& transfer : transfer_names())
    for (const std::string order : {"musl", "usl", "usf"}) {
      if (!goes_with(transfer, GetParam()) || !riedel::test::transfer<2>(transfer)->traits().goes_with(order)) continue;
      const BiaxialCase values = coarse_values(
          {"scheme=" + GetParam(), "time.order=" + order, "time.transfer=" + transfer, "nonlocal.length=0.0"});
      Simulation<2> simulation = warm(make_biaxial(values, catalogue()));
      EXPECT_EQ(allocations_in_steps(simulation), 0) << transfer << ", " << order;
    }
}

TEST_P(AllocationTest, AreNoneInAStepOfTheNonlocalModelBetweenTwoSearches) {
  for (const std::string& search : catalogue().in_2d.searches.names()) {
    const BiaxialCase values =
        coarse_values({"scheme=" + GetParam(), "nonlocal.search=" + search, "loading.ramp_time=1e-4"});
    Simulation<2> simulation = warm(make_biaxial(values, catalogue()));
    const std::int64_t before = searches(simulation);
    EXPECT_GT(before, 0);
    EXPECT_EQ(allocations_in_steps(simulation), 0) << search;
    EXPECT_EQ(searches(simulation), before) << "there was a search in between";
  }
}

TEST_P(AllocationTest, AreNoneWithRigidPlatensAndPressureOnPoints) {
  BiaxialCase values = coarse_values({"scheme=" + GetParam(), "nonlocal.length=0.0", "loading.platen=rigid_points"});
  values.loading.lateral = BiaxialCase::Lateral::points; // whether or not the scheme starts in equilibrium so
  Simulation<2> simulation = warm(make_biaxial(values, catalogue()));
  EXPECT_EQ(allocations_in_steps(simulation), 0);
}

class BoundaryAllocationTest : public testing::TestWithParam<std::string> {};

/// A block falls on a condition in the lowest rows of the grid.
TEST_P(BoundaryAllocationTest, AreNoneInAStep) {
  State<2> state = elastic_state<2>({8, 8}, 0.1, 2, 4, [](const Vec<2>&) { return true; });
  state.bodies[0].points.velocity.fill(0, 1.0);
  state.bodies[0].points.velocity.fill(1, -2.0);
  const NodeBox<2> place{.first = {2, 2}, .last = {state.grid.nodes[0] - 3, 4}, .axis = 1};
  Model<2> model = model_with<2>("gimp");
  const auto& entry = catalogue().in_2d.boundaries.find(GetParam());
  model.conditions.push_back(entry.make("tested", place, Values(entry.description.parameters)));
  Simulation<2> simulation = warm(Simulation<2>(std::move(model), std::move(state)));
  EXPECT_EQ(allocations_in_steps(simulation), 0);
  EXPECT_NE(simulation.state().boundary_loss + std::abs(simulation.boundary("tested").report().reaction), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Registry, BoundaryAllocationTest, testing::ValuesIn(catalogue().in_2d.boundaries.names()),
                         [](const auto& tested) { return tested.param; });

/// A block as soft as a liquid is sheared until points of different slabs lie in the same rows.
TEST_P(AllocationTest, AreNoneWhenPointsAreSortedAnew) {
  State<2> state =
      elastic_state<2>({12, 30}, 0.1, 1, 14, [](const Vec<2>&) { return true; }, {{"youngs_modulus", 1.0}});
  Points<2>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) points.velocity[1][p] = 100.0 * (points.position[0][p] - 0.6);
  Model<2> model = model_with<2>(GetParam());
  model.fixed_time_step = 1e-4;
  Simulation<2> simulation = warm(Simulation<2>(std::move(model), std::move(state)));
  const std::vector<Index> places = simulation.state().bodies[0].points.place;
  EXPECT_EQ(allocations_in_steps(simulation), 0);
  EXPECT_NE(simulation.state().bodies[0].points.place, places) << "nothing was sorted";
}

const void* volatile escaped = nullptr; ///< or clang leaves the allocations out

TEST(AllocationCounter, CountsWhatIsTaken) {
  allocations = 0;
  counting = true;
  std::vector<double> vector(100);
  AlignedVector<double> aligned(100);
  escaped = vector.data();
  escaped = aligned.data();
  counting = false;
  EXPECT_EQ(allocations, 2) << vector.size() + aligned.size();
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, AllocationTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
