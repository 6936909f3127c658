#include "core/io/progress.hpp"

#include <gmock/gmock.h>
#include <sstream>

using namespace riedel;
using testing::HasSubstr;

TEST(ProgressLine, TellsEachTenthOnceWhenNotOnATerminal) {
  std::ostringstream out;
  {
    Progress progress("biaxial", out, false);
    for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0);
  }
  const std::string text = out.str();
  EXPECT_EQ(std::ranges::count(text, '\n'), 11); // 0 %, 10 %, ..., 100 %
  EXPECT_THAT(text, HasSubstr("biaxial: 70 %, "));
  EXPECT_THAT(text, HasSubstr("biaxial: 100 %, took "));
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(ProgressLine, IsOneLineOnATerminal) {
  std::ostringstream out;
  {
    Progress progress("biaxial", out, true);
    progress.update(0.5, "41.2°");
    progress.update(1.0);
  }
  EXPECT_EQ(std::ranges::count(out.str(), '\n'), 1);
  EXPECT_EQ(out.str().back(), '\n');
  EXPECT_THAT(out.str(), HasSubstr("50 %, 0 s left, 41.2°"));
}

TEST(ProgressLine, SaysNothingWhenNothingHappens) {
  std::ostringstream out;
  { Progress progress("biaxial", out, true); }
  EXPECT_EQ(out.str(), "");
}

TEST(Duration, IsTextForPeople) {
  EXPECT_EQ(duration_text(11.7), "12 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3605.0), "1 h 00 min");
  EXPECT_EQ(duration_text(-1.0), "0 s");
}
