/// One process at a time writes to a folder of results.
#include "apps/campaign.hpp"
#include "core/base/error.hpp"
#include "core/run/folder_lock.hpp"

#include <cerrno>
#include <gmock/gmock.h>
#include <thread>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(FolderLock, RefusesASecondHolderAndTellsOfTheFirst) {
  const TemporaryFolder here;
  const FolderLock lock(here.path(), "riedel biaxial --out x");
  EXPECT_THAT([&] { const FolderLock second(here.path(), "riedel verify"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr(here.path().string()), HasSubstr("process " + std::to_string(::getpid()) + " on "),
                        ContainsRegex(" since 20[0-9-]+ [0-9:]+ UTC, 'riedel biaxial --out x'"))));
}

TEST(FolderLock, LeavesNoFileBehind) {
  const TemporaryFolder here;
  { const FolderLock lock(here.path(), "riedel biaxial"); }
  EXPECT_TRUE(fs::is_empty(here.path()));
  const FolderLock again(here.path(), "riedel biaxial");
}

TEST(FolderLock, IsGoneWithAProcessThatIsKilled) {
  const TemporaryFolder here;
  const pid_t holder = ::fork();
  if (holder == 0) {
    const FolderLock lock(here.path(), "riedel biaxial");
    here.file("held", "");
    ::pause();
    ::_exit(1);
  }
  while (!fs::exists(here / "held")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_THROW(FolderLock(here.path(), "riedel biaxial"), InputError);
  ::kill(holder, SIGKILL);
  EXPECT_NO_THROW(FolderLock(here.path(), "riedel biaxial"));
  ::waitpid(holder, nullptr, 0);
}

TEST(FolderLock, FollowsNoLink) {
  const TemporaryFolder here;
  const std::string other = here.file("other", "mine");
  fs::create_directory(here / "out");
  fs::create_symlink(other, here / "out" / FolderLock::file_name);
  EXPECT_THAT([&] { const FolderLock lock(here / "out", "riedel biaxial"); },
              ThrowsMessage<InputError>(HasSubstr("is a symbolic link")));
  EXPECT_EQ(file_content(other), "mine");
}

TEST(FolderLock, GoesOnWithAWarningWhereTheFileSystemKnowsNoLocks) {
  const TemporaryFolder here;
  const auto no_locks = [](int, int) { return errno = ENOLCK, -1; };
  testing::internal::CaptureStderr();
  { const FolderLock lock(here.path(), "riedel biaxial", no_locks); }
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("riedel: warning: " + here.path().string()), HasSubstr("does not support locks")));
}

/// A run that lasts, started in `out_`.
class HeldFolder : public CampaignTest {
protected:
  [[nodiscard]] std::unique_ptr<Process> started() const {
    auto first = std::make_unique<Process>(
        folder_, coarse_case(out_, {"--set", "loading.final_strain=0.5", "--set", "loading.speed=0.01"}));
    while (first->running() && !fs::exists(out_ / "points.pvd"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return first;
  }
  /// In a separate folder, since the output of a program goes to files.
  [[nodiscard]] Outcome run_beside(Words words) const {
    const auto place = std::ranges::find(words, "OUT");
    if (place != words.end()) *place = out_.string();
    const Outcome outcome = Process(folder_, words, RLIM_INFINITY, "second").finish();
    EXPECT_THAT(outcome.err, HasSubstr("is being written to by process")) << words.front();
    return outcome;
  }
};

TEST_F(HeldFolder, IsRefusedToEveryCommandAlsoWithForce) {
  const auto first = started();
  const std::string before = file_content(out_ / "case.toml");
  for (const Words& words :
       {coarse_case(out_), coarse_case(out_, {"--force"}), Words{"element", "triaxial", "--out", "OUT", "--force"},
        Words{"verify", "--problems", "bar", "--schemes", "gimp", "--out", "OUT", "--force"},
        Words{"compare", "--schemes", "gimp,linear", "--out", "OUT", "--force"},
        Words{"reproduce", "--figure", "2", "--out", "OUT", "--force"}})
    EXPECT_EQ(run_beside(words).code, 2) << words.front();
  EXPECT_TRUE(first->running());
  EXPECT_EQ(file_content(out_ / "case.toml"), before);
  EXPECT_FALSE(fs::exists(out_ / "campaign.json"));
  EXPECT_EQ(first->finish(SIGTERM).code, 143);
  EXPECT_TRUE(fs::exists(out_ / "points" / "points_000000.vtp"));
}

TEST_F(HeldFolder, OfACampaignIsRefusedToAnotherAndToCollect) {
  Process first(folder_, all({"--schemes", "gimp,linear", "--set", "loading.final_strain=0.5", "--set",
                              "loading.speed=0.01", "--threads", "1"}));
  while (first.running() && !fs::exists(out_ / "scheme=gimp" / "points.pvd"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(run_beside(all({"--schemes", "gimp,linear,cpdi"})).code, 2);
  EXPECT_EQ(run_beside(all({"--schemes", "gimp", "--force"})).code, 2);
  EXPECT_EQ(run_beside({"collect", "OUT"}).code, 2);
  EXPECT_EQ(run_beside(coarse_case(out_ / "scheme=gimp", {"--force"})).code, 2) << "a run holds its own folder";
  EXPECT_TRUE(first.running());
  first.finish(SIGKILL);
}

TEST_F(HeldFolder, LetsOneOfTwoBegin) {
  Process first(folder_, coarse_case(out_)), second(folder_, coarse_case(out_), RLIM_INFINITY, "second");
  const int one = first.finish().code, other = second.finish().code;
  EXPECT_EQ(std::min(one, other), 0);
  EXPECT_EQ(std::max(one, other), 2);
  const std::string alone = file_content(out_ / "history.csv");
  ASSERT_EQ(run(folder_, coarse_case(folder_ / "alone")).code, 0);
  EXPECT_EQ(alone, file_content(folder_ / "alone" / "history.csv"));
}

} // namespace
} // namespace riedel::test
