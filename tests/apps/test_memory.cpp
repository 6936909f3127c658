/// The memory of a run: estimated, measured, and a run refused when too little is available.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/memory_needed.hpp"
#include "apps/fake_catalogue.hpp"
#include "apps/program.hpp"
#include "core/run/memory_there.hpp"
#include "support/patterns.hpp"
#include "support/problems.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(MemoryNeeded, CountsThePairsOfALattice) {
  const std::array<double, 3> counts{7, 5, 3}, spacing{1.0, 1.5, 0.7};
  for (const double radius : {0.5, 1.0, 2.3, 4.0, 100.0}) {
    double pairs = 0.0;
    for (int p = 0; p < 7 * 5 * 3; ++p)
      for (int q = 0; q < 7 * 5 * 3; ++q) {
        const double x = (p % 7 - q % 7) * 1.0, y = (p / 7 % 5 - q / 7 % 5) * 1.5, z = (p / 35 - q / 35) * 0.7;
        pairs += x * x + y * y + z * z <= radius * radius;
      }
    EXPECT_EQ(pairs_within(counts, spacing, radius), pairs) << radius;
  }
}

class Memory : public testing::Test {
protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitizer has memory of its own";
#endif
  }
  /// A case that ends at once. @return settings that follow the command
  static Words brief(const Words& settings) {
    Words words;
    for (const char* setting :
         {"loading.final_strain=2e-5", "loading.speed=1", "imperfection.size=[0,0]", "output.every_strain=1e-5"})
      words.insert(words.end(), {"--set", setting});
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    return words;
  }
  /// Under bash with a limit. @return exit code; what was printed is in "out" and "err"
  [[nodiscard]] int limited(const std::string& limit, const Words& words) const {
    std::string line = "ulimit " + limit + "; exec '" RIEDEL_PROGRAM "'";
    for (const std::string& word : words) line += " '" + word + "'";
    const std::string script = folder_.file("script", line + "\n");
    return WEXITSTATUS(std::system(
        ("bash " + script + " >" + (folder_ / "out").string() + " 2>" + (folder_ / "err").string()).c_str()));
  }
  /// Maximum memory in use at any time [bytes].
  static double measured(const Words& words) {
    std::vector<char*> argv{const_cast<char*>(RIEDEL_PROGRAM)};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      const int nowhere = ::open("/dev/null", O_WRONLY);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    int status = 0;
    rusage use{};
    ::wait4(child, &status, 0, &use);
    EXPECT_EQ(status, 0);
    return 1024.0 * static_cast<double>(use.ru_maxrss);
  }
  TemporaryFolder folder_;
};

TEST_F(Memory, IsAsMuchAsIsEstimated) {
  for (const Words& settings :
       {Words{"grid.cells=[100,350]", "nonlocal.length=0"}, Words{"grid.cells=[36,126]", "nonlocal.length=4e-3"},
        Words{"grid.dimensions=3", "grid.cells=[24,84]", "specimen.depth_cells=3", "nonlocal.length=0"}}) {
    Words check = brief(settings), run = check;
    check.insert(check.begin(), "check");
    const Outcome told = test::run(folder_, check);
    double estimate = 0.0; // in MB
    const std::size_t line = told.out.find("# memory: ");
    ASSERT_NE(line, std::string::npos) << told.out;
    ASSERT_EQ(std::sscanf(told.out.c_str() + line, "# memory: about %lf MB\n", &estimate), 1) << told.out;
    run.insert(run.begin(), {"biaxial", "--threads", "1", "--force", "--out", (folder_ / "run").string()});
    const double maximum = 1e-6 * measured(run);
    EXPECT_GT(estimate, 0.6 * maximum) << settings.front();
    EXPECT_LT(estimate, 1.6 * maximum) << settings.front();
  }
}

TEST_F(Memory, ThatACaseLacksIsToldBeforeTheRunWithItsKeys) {
  Words words = brief({"grid.cells=[400,1400]", "nonlocal.length=4e-3"});
  words.insert(words.begin(), {"biaxial", "--out", (folder_ / "run").string()});
  EXPECT_EQ(limited("-v 2000000", words), 2);
  EXPECT_THAT(file_content(folder_ / "err"),
              AllOf(HasSubstr("--set grid.cells: the run needs about "),
                    ContainsRegex("GB of memory, [0-9.]+ GB of them"), HasSubstr("ulimit -v"),
                    HasSubstr("specimen.points_per_cell"), HasSubstr("nonlocal.length")));
  EXPECT_FALSE(fs::exists(folder_ / "run"));
}

/// From a limit at which the program cannot even be loaded to one at which it has enough.
TEST_F(Memory, OfWhateverAmountEndsWithAMessageAndNoCrash) {
  Words words = brief({"grid.cells=[40,140]", "nonlocal.length=2e-3", "output.plots=false"});
  words.insert(words.begin(), {"biaxial", "--threads", "2", "--force", "--out", (folder_ / "run").string()});
  bool told = false, done = false;
  // A crash hides in a few MB.
  for (int megabytes = 60; megabytes <= 1200 && !done; megabytes += megabytes < 120 ? 2 : 20) {
    const int code = limited("-v " + std::to_string(megabytes * 1000), words);
    const std::string message = file_content(folder_ / "err");
    SCOPED_TRACE(std::to_string(megabytes) + " MB: " + message);
    EXPECT_THAT(code, testing::AnyOf(0, 2, 3, 127)); // 127: the system could not load it
    if (code == 2 || code == 3) {
      told = true;
      EXPECT_THAT(message, HasSubstr("riedel: error: "));
      EXPECT_THAT(message, Not(HasSubstr("internal")));
    }
    done = code == 0;
  }
  EXPECT_TRUE(told);
  EXPECT_TRUE(done);
}

TEST_F(Memory, AndThreadsThatTheSystemDoesNotGiveEndTheRunWithASummary) {
  Words words = brief({"grid.cells=[4,8]", "nonlocal.length=0"});
  words.insert(words.begin(), {"biaxial", "--threads", "900", "--out", (folder_ / "run").string()});
  EXPECT_EQ(limited("-v 3000000 -s 8192", words), 3);
  EXPECT_THAT(file_content(folder_ / "err"), ContainsRegex("the system gives [0-9]+ of 900 threads"));
  const auto summary = json_of(folder_ / "run" / "summary.json");
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_THAT(summary["reason"].get<std::string>(), HasSubstr("threads"));
}

/// A tree like that of a system.
class MemoryOfASystem : public testing::Test {
protected:
  void file(const std::string& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    root_.file(name, text);
  }
  [[nodiscard]] double bytes() const { return memory_there(root_.path()).bytes; }
  TemporaryFolder root_;
};

TEST_F(MemoryOfASystem, IsWhatTheMachineHasLeft) {
  file("proc/meminfo", "MemTotal: 8000 kB\nMemFree: 10 kB\nMemAvailable:    2000 kB\n");
  EXPECT_EQ(bytes(), 2000 * 1024);
}

TEST_F(MemoryOfASystem, IsWhatTheNarrowestControlGroupLeaves) {
  file("proc/meminfo", "MemAvailable: 2000000 kB\n");
  file("proc/self/cgroup", "0::/batch/job\n");
  file("sys/fs/cgroup/batch/job/memory.max", "max\n");
  file("sys/fs/cgroup/batch/job/memory.current", "900\n");
  file("sys/fs/cgroup/batch/memory.max", "5000\n");
  file("sys/fs/cgroup/batch/memory.current", "3000\n");
  file("sys/fs/cgroup/batch/memory.stat", "anon 100\ninactive_file 500\n");
  EXPECT_EQ(bytes(), 2500);
  EXPECT_EQ(memory_there(root_.path()).by, "the control group leaves");
}

TEST_F(MemoryOfASystem, KnowsTheFirstVersionOfControlGroupsToo) {
  file("proc/meminfo", "MemAvailable: 2000000 kB\n");
  file("proc/self/cgroup", "12:cpu,cpuacct:/\n4:memory:/job\n");
  file("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "7000\n");
  file("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1000\n");
  file("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  file("sys/fs/cgroup/memory/memory.usage_in_bytes", "1000\n");
  EXPECT_EQ(bytes(), 6000);
}

} // namespace
} // namespace riedel::test
