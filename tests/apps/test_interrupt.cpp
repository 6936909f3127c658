#include "core/run/interrupt.hpp"

#include <gtest/gtest.h>
#include <thread>

using riedel::Interrupt;

TEST(InterruptDeathTest, TellsWhichSignalCame) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt);
    std::raise(signal);
    EXPECT_TRUE(interrupt);
    EXPECT_EQ(interrupt.signal(), signal);
    EXPECT_EQ(interrupt.exit_code(), code);
  }
}

TEST(InterruptDeathTest, LetsTheSecondSignalEndTheProgram) {
  for (const int second : {SIGINT, SIGTERM}) {
    const auto interrupted_twice = [&] {
      const Interrupt interrupt;
      std::raise(SIGINT);
      std::this_thread::sleep_for(std::chrono::milliseconds(600));
      std::raise(second);
    };
    EXPECT_EXIT(interrupted_twice(), testing::KilledBySignal(second), "");
  }
}

TEST(InterruptDeathTest, TakesASignalSentTwiceForOne) {
  const Interrupt interrupt;
  std::raise(SIGTERM);
  std::raise(SIGTERM);
  EXPECT_EQ(interrupt.signal(), SIGTERM);
}

TEST(InterruptDeathTest, GivesTheSignalsBack) {
  const auto interrupted_later = [] {
    { const Interrupt interrupt; }
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(interrupted_later(), testing::KilledBySignal(SIGTERM), "");
}
