#include "apps/output_folder.hpp"
#include "core/base/error.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

using namespace riedel;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {
void expect_refused(const std::filesystem::path& folder, const char* reason) {
  EXPECT_THAT([&] { prepare_output_folder(folder, false); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("--out " + folder.string()), HasSubstr(reason))));
}
} // namespace

TEST(OutputFolder, IsCreatedWithItsParentsAndEmpty) {
  const TemporaryFolder here;
  prepare_output_folder(here / "a/b/c", false);
  EXPECT_TRUE(std::filesystem::is_empty(here / "a/b/c"));
  prepare_output_folder(here / "a/b/c", false); // a second time, as nothing was written
}

TEST(OutputFolder, IsRefusedWhenItHoldsResults) {
  for (const char* result : {"case.toml", "history.csv", "verify.csv", "summary.json"}) {
    const TemporaryFolder here;
    here.file(result, "old");
    expect_refused(here.path(), "--force");
    EXPECT_EQ(file_content(here / result), "old");
  }
}

TEST(OutputFolder, MayHoldOtherFiles) {
  const TemporaryFolder here;
  here.file("notes.txt", "mine");
  prepare_output_folder(here.path(), false);
  prepare_output_folder(here.path(), true);
  EXPECT_EQ(file_content(here / "notes.txt"), "mine");
}

TEST(OutputFolder, WithForceLosesTheOldSummaryButNotTheCase) {
  const TemporaryFolder here;
  for (const char* result : {"case.toml", "history.csv", "summary.json", "points.pvd"}) here.file(result, "old");
  prepare_output_folder(here.path(), true);
  EXPECT_EQ(file_content(here / "case.toml"), "old"); // it may be the very case that is being run
  EXPECT_FALSE(std::filesystem::exists(here / "summary.json"));
  EXPECT_FALSE(std::filesystem::exists(here / "points.pvd"));
}

TEST(OutputFolder, WithForceLosesPicturesAndFramesOfTheOldRunButNoOtherFile) {
  const TemporaryFolder here;
  std::filesystem::create_directory(here / "points");
  for (const char* result : {"void_ratio.png", "points/points_000013.vtp", "points/points_000014.vtp.part"})
    here.file(result, "old");
  for (const char* other : {"my_void_ratio.png", "points/points_of_interest.vtp"}) here.file(other, "mine");
  prepare_output_folder(here.path(), true);
  for (const char* result : {"void_ratio.png", "points/points_000013.vtp", "points/points_000014.vtp.part"})
    EXPECT_FALSE(std::filesystem::exists(here / result)) << result;
  for (const char* other : {"my_void_ratio.png", "points/points_of_interest.vtp"})
    EXPECT_EQ(file_content(here / other), "mine");
}

TEST(OutputFolder, TellsWhyItCannotBeUsed) {
  const TemporaryFolder here;
  const std::filesystem::path file = here.file("file", "");
  expect_refused(file, "is a file");
  expect_refused(file / "inside", "cannot be created: Not a directory");
  expect_refused("/proc/self", "cannot be written to"); // exists, and nobody may write there
}
