#include "core/run/run.hpp"
#include "core/run/watches.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Loop = riedel::Run<2>; // testing::Test has its own Run

Simulation<2> block_with_step(double time_step) {
  Model<2> model = model_with<2>("gimp");
  model.fixed_time_step = time_step;
  return Simulation<2>(std::move(model), elastic_state<2>({2, 2}, 0.1, 2, 3, [](const Vec<2>&) { return true; }));
}

/// At rest, with steps of 1/64 s, so that times are exact.
Simulation<2> resting_block() { return block_with_step(1.0 / 64); }

TEST(Run, WritesAtTheStartAndWheneverAnIntervalIsOver) {
  Simulation<2> simulation = resting_block();
  std::vector<std::int64_t> written;
  Loop run(simulation);
  run.every(4.0 / 64, [&] { written.push_back(simulation.state().step); });
  EXPECT_EQ(run.until(10.0 / 64).go(), "time");
  EXPECT_EQ(simulation.state().step, 10);
  EXPECT_THAT(written, ElementsAre(0, 4, 8));
  run.finish();
  EXPECT_THAT(written, ElementsAre(0, 4, 8, 10)) << "the present";
  run.finish();
  EXPECT_EQ(written.size(), 4U) << "is written once";
}

TEST(Run, AsksItsStopsInTheirOrderBeforeEachStep) {
  Simulation<2> simulation = resting_block();
  bool interrupted = false;
  Loop run(simulation);
  run.after_steps(3, [&] { interrupted = true; }).until("interrupt", [&] { return interrupted; }).until_step(3);
  EXPECT_EQ(run.go(), "interrupt") << "both are reached, and this one was added first";
  EXPECT_EQ(run.go(), "interrupt");
  EXPECT_EQ(simulation.state().step, 3) << "a stop that is reached lets no step be taken";
}

TEST(Run, TakesNoStepWhereAStopIsReachedFromTheStart) {
  Simulation<2> simulation = resting_block();
  Loop run(simulation);
  run.until("first step", [&] { return simulation.state().step == 1; });
  EXPECT_EQ(run.until(0.0).go(), "time");
  EXPECT_EQ(simulation.state().step, 0);
}

TEST(Run, LetsMonitorsAndWritersActInTheOrderInWhichTheyWereAdded) {
  Simulation<2> simulation = resting_block();
  std::string order;
  Loop run(simulation);
  run.every(1.0 / 64, [&] { order += 'w'; }).after_steps(1, [&] { order += 'm'; }).after_steps(2, [&] {
    order += '2';
  });
  run.until_step(3).go();
  EXPECT_EQ(order, "w"
                   "wm"
                   "wm2"
                   "wm");
}

TEST(Run, GoesOnWhereItStoppedAndWritesNothingTwice) {
  Simulation<2> simulation = resting_block();
  std::vector<std::int64_t> written;
  std::int64_t last = 2;
  Loop run(simulation);
  run.every(0.0, [&] { written.push_back(simulation.state().step); });
  run.until("pause", [&] { return simulation.state().step >= last; });
  run.begin();
  EXPECT_THAT(written, ElementsAre(0));
  run.go();
  last = 4;
  run.go();
  EXPECT_THAT(written, ElementsAre(0, 1, 2, 3, 4));
}

TEST(Run, TakesItsStepsByTheGivenStepper) {
  Simulation<2> simulation = resting_block();
  int steps = 0;
  Loop run(simulation, [&](const auto& step) {
    ++steps;
    step();
  });
  run.until_step(5).go();
  EXPECT_EQ(steps, 5);
}

TEST(Run, LetsThroughWhatAStepThrows) {
  Simulation<2> simulation = resting_block();
  simulation.state().bodies.front().points.velocity[0][0] = 1e9; // off the grid
  Loop run(simulation);
  EXPECT_THROW(run.until_step(5).go(), RunError);
}

TEST(KineticShare, LeavesOutTheFirstHalfPerCent) {
  KineticShare share;
  share.record(0.004, {.kinetic = 5.0, .internal = 1.0});
  EXPECT_TRUE(std::isnan(share.maximum()));
  share.record(0.005, {.kinetic = 0.2, .internal = -1.0});
  share.record(0.006, {.kinetic = 0.1, .internal = 1.0});
  share.record(0.007, {.kinetic = 9.0, .internal = 0.0});
  EXPECT_EQ(share.maximum(), 0.2);
}

TEST(TimeStepWatch, WarnsOnceOfAStepThatIsOverTheStableOne) {
  const double limit = block_with_step(1.0 / 64).crossing_time();
  const Simulation<2> stable = block_with_step(0.5 * limit), unstable = block_with_step(2.0 * limit);
  TimeStepWatch watch;
  testing::internal::CaptureStderr();
  watch.record(stable);
  EXPECT_NEAR(watch.maximum(), 0.5, 1e-12);
  EXPECT_EQ(watch.doubt(), "");
  watch.record(unstable);
  watch.record(unstable);
  const std::string warned = testing::internal::GetCapturedStderr();
  EXPECT_THAT(warned, HasSubstr("over the stable limit"));
  EXPECT_EQ(warned.find("over the stable limit"), warned.rfind("over the stable limit"));
  EXPECT_NEAR(watch.maximum(), 2.0, 1e-12);
  EXPECT_THAT(watch.doubt(), HasSubstr("2 times the stable one"));
}

} // namespace
} // namespace riedel::test
