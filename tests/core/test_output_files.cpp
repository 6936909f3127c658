#include "core/base/error.hpp"
#include "core/io/history.hpp"
#include "temporary_folder.hpp"

#include <cmath>
#include <csignal>
#include <gmock/gmock.h>
#include <sys/resource.h>

using namespace riedel;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

/// As if the disk were full: no file of this process may grow beyond a few bytes.
class FullDisk {
public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  void (*handler_)(int);
  rlimit before_{};
};

} // namespace

TEST(AtomicFile, ReplacesTheOldTextAndLeavesNoDraft) {
  const TemporaryFolder folder;
  const auto path = folder / "summary.json";
  write_atomically(path, "old");
  write_atomically(path, "new");
  EXPECT_EQ(file_content(path), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(AtomicFile, KeepsTheOldTextWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto path = folder / "summary.json";
  write_atomically(path, "old");
  {
    const FullDisk full(10);
    EXPECT_THAT([&] { write_atomically(path, std::string(1000, 'x')); },
                ThrowsMessage<RunError>(AllOf(HasSubstr(path.string()), HasSubstr("File too large"))));
  }
  EXPECT_EQ(file_content(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(AtomicFile, WritesThroughNoLinkThatWaitsForItsDraft) {
  const TemporaryFolder folder;
  const auto path = folder / "summary.json";
  const std::string other = folder.file("other", "mine");
  std::filesystem::create_symlink(other, path.string() + ".part");
  write_atomically(path, "new");
  EXPECT_EQ(file_content(path), "new");
  EXPECT_EQ(file_content(other), "mine");
}

TEST(AtomicFile, ReplacesALinkAndLeavesItsTarget) {
  const TemporaryFolder folder;
  const auto path = folder / "summary.json";
  const std::string other = folder.file("other", "mine");
  std::filesystem::create_symlink(other, path);
  write_atomically(path, "new");
  EXPECT_FALSE(std::filesystem::is_symlink(path));
  EXPECT_EQ(file_content(path), "new");
  EXPECT_EQ(file_content(other), "mine");
}

TEST(AtomicFile, LeavesADeviceInItsPlace) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const TemporaryFolder folder;
  const auto path = folder / "link";
  std::filesystem::create_symlink("/dev/full", path);
  EXPECT_THAT([&] { write_atomically(path, "new"); },
              ThrowsMessage<RunError>("cannot write " + path.string() + ": No space left on device"));
  EXPECT_TRUE(std::filesystem::is_symlink(path));
}

TEST(AtomicFile, KnowsItsDrafts) {
  EXPECT_TRUE(is_draft_of("summary.json.0123456789abcdef.part", "summary.json"));
  for (const char* other :
       {"summary.json", "summary.json.part", "summary.json.0123456789abcdeg.part", "history.csv.0123456789abcdef.part"})
    EXPECT_FALSE(is_draft_of(other, "summary.json")) << other;
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  write_atomically(folder / longest, "x");
  EXPECT_EQ(file_content(folder / longest), "x");
}

TEST(OutputFile, FollowsNoLink) {
  const TemporaryFolder folder;
  const std::string other = folder.file("other", "mine");
  std::filesystem::create_symlink(other, folder / "history.csv");
  EXPECT_THAT([&] { OutputFile(folder / "history.csv"); }, ThrowsMessage<RunError>(HasSubstr("is a symbolic link")));
  EXPECT_EQ(file_content(other), "mine");
}

TEST(AtomicFile, KeepsEveryByte) {
  const TemporaryFolder folder;
  std::string bytes(70000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7);
  write_atomically(folder / "picture.png", bytes);
  EXPECT_EQ(file_content(folder / "picture.png"), bytes);
}

TEST(AtomicFile, TellsWhyItCannotWrite) {
  EXPECT_THAT(
      [] { write_atomically("/no/such/folder/file", "x"); },
      ThrowsMessage<RunError>(AllOf(HasSubstr("/no/such/folder/file"), HasSubstr("No such file or directory"))));
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "name/inside"); // a folder cannot be replaced by a file
  EXPECT_THAT([&] { write_atomically(folder / "name", "x"); }, ThrowsMessage<RunError>(HasSubstr("directory")));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFile, TellsThatTheDiskIsFull) {
  OutputFile file("/dev/full");
  EXPECT_THAT([&] { file.write("x"); }, ThrowsMessage<RunError>("cannot write /dev/full: No space left on device"));
}

TEST(HistoryFile, CanBeReadWhileItIsWrittenAndGivesTheSameBits) {
  const TemporaryFolder folder;
  const auto path = folder / "history.csv";
  History history(path, {"step", "time_s", "phi_mob_deg"});
  EXPECT_EQ(file_content(path), "step,time_s,phi_mob_deg\n");
  history.add(std::vector{100.0, 0.1 + 0.2, 1.0 / 3.0});
  EXPECT_EQ(file_content(path), "step,time_s,phi_mob_deg\n100,0.30000000000000004,0.3333333333333333\n");
}

TEST(HistoryFile, RefusesARowOfAnotherLength) {
  const TemporaryFolder folder;
  History history(folder / "history.csv", {"a", "b"});
  EXPECT_THROW(history.add(std::vector{1.0}), std::logic_error);
}

TEST(HistoryFile, TellsThatTheDiskIsFull) {
  EXPECT_THAT([] { History("/dev/full", {"step"}); },
              ThrowsMessage<RunError>("cannot write /dev/full: No space left on device"));
  const TemporaryFolder folder;
  const auto path = folder / "history.csv";
  History history(path, {"step"});
  history.add(std::vector{1.0});
  const FullDisk full(8);
  EXPECT_THAT([&] { history.add(std::vector{123456.0}); }, ThrowsMessage<RunError>(HasSubstr("File too large")));
  EXPECT_EQ(file_content(path), "step\n1\n"); // what was written stays, and half a row is taken back
}
