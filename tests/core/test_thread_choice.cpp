/// The choice of threads on an artificial machine, whose clock advances by the time that a step would take.
#include "core/base/thread_choice.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
namespace {

/// A machine with a clock, and the time of a step on it.
struct Machine {
  double now = 0.0;
  std::function<double(int threads, double now)> step_seconds;

  ThreadChoice::Clock clock() {
    return [this] { return now; };
  }
  /// Takes steps until `end` [s]. @return their number
  std::int64_t run(ThreadChoice& choice, double end) {
    std::int64_t steps = 0;
    for (; now < end; ++steps) choice.step([this] { now += step_seconds(omp_get_max_threads(), now); });
    return steps;
  }
};

constexpr double one_thread = 4e-4; ///< a step on one thread [s]

double quiet(int threads, double) { return one_thread / threads; }

/// Threads wait for one that does not have its processor.
double busy(int threads, double) { return threads == 1 ? 1.4 * one_thread : 0.04; }

class ChoiceOfThreads : public testing::Test {
protected:
  int before_ = omp_get_max_threads();
  void TearDown() override { omp_set_num_threads(before_); }
};

TEST_F(ChoiceOfThreads, TakesAllOnAQuietMachineAndLosesLittleByLooking) {
  for (const int maximum : {2, 3, 8}) {
    Machine machine{.step_seconds = quiet};
    ThreadChoice choice({1, maximum}, machine.clock());
    const std::int64_t steps = machine.run(choice, 5.0);
    EXPECT_EQ(choice.threads(), maximum);
    EXPECT_EQ(choice.max_used(), maximum);
    EXPECT_GT(static_cast<double>(steps), 0.97 * 5.0 * maximum / one_thread) << maximum;
  }
}

TEST_F(ChoiceOfThreads, StaysOnOneWhereOthersAreBusy) {
  Machine machine{.step_seconds = busy};
  ThreadChoice choice({1, 2}, machine.clock());
  const std::int64_t steps = machine.run(choice, 10.0);
  EXPECT_EQ(choice.threads(), 1);
  EXPECT_GT(static_cast<double>(steps), 0.95 * 10.0 / (1.4 * one_thread));
}

TEST_F(ChoiceOfThreads, TakesOneWhereStepsAreTooShortToShare) {
  Machine machine{.step_seconds = [](int threads, double) { return 5e-6 / threads + (threads > 1 ? 2e-5 : 0.0); }};
  ThreadChoice choice({1, 4}, machine.clock());
  (void)machine.run(choice, 1.0);
  EXPECT_EQ(choice.threads(), 1);
}

TEST_F(ChoiceOfThreads, FindsTheNumberBeyondWhichMoreAreSlower) {
  Machine machine{.step_seconds = [](int threads, double) { return 1e-3 * (1.0 / threads + 0.02 * threads); }};
  ThreadChoice choice({1, 64}, machine.clock());
  (void)machine.run(choice, 2.0);
  EXPECT_EQ(choice.threads(), 8); // 285 us; 4: 330, 16: 382
}

TEST_F(ChoiceOfThreads, FollowsAMachineThatBecomesBusyAndQuietAgain) {
  Machine machine{
      .step_seconds = [](int threads, double now) { return (now > 2.0 && now < 12.0 ? busy : quiet)(threads, now); }};
  ThreadChoice choice({1, 2}, machine.clock());
  (void)machine.run(choice, 1.9);
  EXPECT_EQ(choice.threads(), 2);
  (void)machine.run(choice, 3.0);
  EXPECT_EQ(choice.threads(), 1) << "a second after it has become busy";
  (void)machine.run(choice, 12.0);
  EXPECT_EQ(choice.threads(), 1);
  (void)machine.run(choice, 60.0);
  EXPECT_EQ(choice.threads(), 2) << "some time after it has become quiet";
}

/// Another process takes a processor away for 5 ms, ten times a second.
TEST_F(ChoiceOfThreads, DoesNotGiveWayToShortDisturbances) {
  double last = 0.0;
  Machine machine{.step_seconds = [&](int threads, double now) {
    if (now - last < 0.1) return quiet(threads, now);
    last = now;
    return quiet(threads, now) + 5e-3;
  }};
  ThreadChoice choice({1, 2}, machine.clock());
  const std::int64_t steps = machine.run(choice, 20.0);
  EXPECT_EQ(choice.max_used(), 2);
  EXPECT_GT(static_cast<double>(steps), 0.90 * 20.0 * 2.0 / one_thread); // 5 % go to the disturbances themselves
}

TEST_F(ChoiceOfThreads, CanBeBoundToANumber) {
  Machine machine{.step_seconds = quiet};
  ThreadChoice choice({3, 3}, machine.clock());
  (void)machine.run(choice, 0.5);
  EXPECT_EQ(omp_get_max_threads(), 3);
  EXPECT_EQ(choice.max_used(), 3);
}

/// A step of a huge case takes seconds; the search must end after few of them.
TEST_F(ChoiceOfThreads, NeedsFewOfLongSteps) {
  Machine machine{.step_seconds = [](int threads, double) { return 3.0 / threads; }};
  ThreadChoice choice({1, 8}, machine.clock());
  (void)machine.run(choice, 60.0);
  EXPECT_EQ(choice.threads(), 8);
}

} // namespace
} // namespace riedel::test
