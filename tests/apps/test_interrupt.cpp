#include "apps/interrupt.hpp"

#include <gtest/gtest.h>

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
  const auto interrupted_twice = [] {
    const Interrupt interrupt;
    std::raise(SIGINT);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(interrupted_twice(), testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptDeathTest, GivesTheSignalsBack) {
  const auto interrupted_later = [] {
    { const Interrupt interrupt; }
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(interrupted_later(), testing::KilledBySignal(SIGTERM), "");
}
