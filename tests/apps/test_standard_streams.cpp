/// Programs are started with streams closed, and their readers go away.
#include "apps/program.hpp"

#include <cstdlib>
#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::HasSubstr;

class Streams : public testing::Test {
protected:
  /// Under bash, in the test's folder. @return the exit code
  [[nodiscard]] int shell(const std::string& line) const {
    const std::string script =
        folder_.file("script", "riedel='" RIEDEL_PROGRAM "'\ncd " + folder_.path().string() + "\n" + line + "\n");
    return WEXITSTATUS(std::system(("bash " + script).c_str()));
  }
  [[nodiscard]] std::string small_case(const std::string& out) const {
    return "$riedel biaxial --out " + out +
           " --threads 1 --set grid.cells=[4,8] --set loading.final_strain=0.001 --set loading.speed=1"
           " --set nonlocal.length=0 --set imperfection.size=[0,0] --set output.plots=false";
  }
  TemporaryFolder folder_;
};

TEST_F(Streams, ThatAreClosedNeverBecomeAFileOfResults) {
  ASSERT_EQ(shell(small_case("open") + " >/dev/null 2>&1"), 0);
  const std::string wanted = file_content(folder_ / "open/history.csv");
  for (const std::string closed : {"2>&-", ">&-", "<&-", "<&- >&- 2>&-"}) {
    EXPECT_EQ(shell(small_case("closed") + " --force " + closed), 0) << closed;
    EXPECT_EQ(file_content(folder_ / "closed/history.csv"), wanted) << closed;
  }
}

TEST_F(Streams, WhoseReaderGoesAwayEndNoRun) {
  EXPECT_EQ(shell(small_case("out") + " 2> >(true) >/dev/null; wait"), 0);
  EXPECT_THAT(file_content(folder_ / "out/summary.json"), HasSubstr("\"status\": \"done\""));
}

TEST_F(Streams, ThatTakeNoMoreAreAnError) {
  EXPECT_EQ(shell("$riedel list > /dev/full 2> err"), 3);
  EXPECT_THAT(file_content(folder_ / "err"), HasSubstr("cannot write to standard output"));
  EXPECT_EQ(shell("(trap '' PIPE; while printf x 2> /dev/null; do :; done; exec $riedel list schemes 2> err) | true\n"
                  "exit ${PIPESTATUS[0]}"),
            128 + SIGPIPE);
  EXPECT_EQ(file_content(folder_ / "err"), "");
}

} // namespace
} // namespace riedel::test
