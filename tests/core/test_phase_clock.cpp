#include "core/base/phase_clock.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace riedel {
namespace {

void pass_ten_milliseconds() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

TEST(PhaseClock, GivesTheTimeOfAnInnerPhaseToItAloneAndReturnsToTheOuterOne) {
  PhaseClock clock;
  clock.start();
  {
    const PhaseClock::Lap outer(clock, Phase::p2g);
    {
      const PhaseClock::Lap inner(clock, Phase::stencils);
      pass_ten_milliseconds();
    }
    pass_ten_milliseconds();
    pass_ten_milliseconds();
  }
  clock.stop();
  EXPECT_GE(clock.seconds(Phase::stencils), 0.01);
  EXPECT_GE(clock.seconds(Phase::p2g), 0.02);
  EXPECT_EQ(clock.seconds(Phase::law), 0.0);
}

TEST(PhaseClock, IsSilentUnlessStarted) {
  PhaseClock clock;
  {
    const PhaseClock::Lap lap(clock, Phase::law);
    pass_ten_milliseconds();
  }
  EXPECT_EQ(clock.seconds(Phase::law), 0.0);
}

TEST(PhaseClock, StartsFromZeroAgain) {
  PhaseClock clock;
  clock.start();
  pass_ten_milliseconds();
  clock.start();
  clock.stop();
  EXPECT_LT(clock.seconds(Phase::other), 0.01);
}

} // namespace
} // namespace riedel
