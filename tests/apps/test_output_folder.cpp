#include "core/base/error.hpp"
#include "core/run/output_folder.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

using namespace riedel;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace fs = std::filesystem;

namespace {

OutputFolder opened(const fs::path& folder, bool force) { return {folder, "riedel biaxial", force}; }
void replace(const fs::path& folder) { opened(folder, true).replace(); }

void expect_refused(const fs::path& folder, const char* reason, bool force = false) {
  EXPECT_THAT([&] { (void)opened(folder, force); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("--out " + folder.string()), HasSubstr(reason))));
}

} // namespace

TEST(OutputFolder, IsCreatedWithItsParentsAndEmpty) {
  const TemporaryFolder here;
  (void)opened(here / "a/b/c", false);
  EXPECT_TRUE(fs::is_empty(here / "a/b/c"));
  (void)opened(here / "a/b/c", false); // a second time, as nothing was written
}

TEST(OutputFolder, IsRefusedWhenItHoldsResults) {
  for (const char* result : {"case.toml", "history.csv", "verify.csv", "summary.json"}) {
    const TemporaryFolder here;
    here.file(result, "old");
    expect_refused(here.path(), "--force");
    EXPECT_EQ(file_content(here / result), "old");
  }
}

TEST(OutputFolder, TakesALinkThatLeadsNowhereForAResult) {
  const TemporaryFolder here;
  fs::create_symlink(here / "nowhere", here / "history.csv");
  expect_refused(here.path(), "--force");
  replace(here.path());
  EXPECT_FALSE(fs::is_symlink(here / "history.csv"));
}

TEST(OutputFolder, MayHoldOtherFiles) {
  const TemporaryFolder here;
  here.file("notes.txt", "mine");
  (void)opened(here.path(), false);
  replace(here.path());
  EXPECT_EQ(file_content(here / "notes.txt"), "mine");
}

TEST(OutputFolder, WithForceKeepsAllUntilTheNewRunIsKnownToBegin) {
  const TemporaryFolder here;
  for (const char* result : {"case.toml", "history.csv", "summary.json"}) here.file(result, "old");
  OutputFolder output = opened(here.path(), true);
  EXPECT_EQ(file_content(here / "history.csv"), "old");
  EXPECT_FALSE(output.is_fresh());
  output.replace();
  EXPECT_FALSE(fs::exists(here / "history.csv"));
  EXPECT_TRUE(output.is_fresh());
}

TEST(OutputFolder, WithForceLosesTheOldSummaryButNotTheCase) {
  const TemporaryFolder here;
  for (const char* result : {"case.toml", "history.csv", "summary.json", "points.pvd"}) here.file(result, "old");
  replace(here.path());
  EXPECT_EQ(file_content(here / "case.toml"), "old"); // it may be the very case that is being run
  EXPECT_FALSE(fs::exists(here / "summary.json"));
  EXPECT_FALSE(fs::exists(here / "points.pvd"));
}

TEST(OutputFolder, WithForceLosesPicturesFramesAndDraftsOfTheOldRunButNoOtherFile) {
  const TemporaryFolder here;
  fs::create_directory(here / "points");
  const auto results = {"void_ratio.png", "points/points_000013.vtp", "points/points_000014.vtp.part",
                        "points/points_000015.vtp.0123456789abcdef.part", "summary.json.0123456789abcdef.part"};
  const auto others = {"my_void_ratio.png", "points/points_of_interest.vtp", "notes.0123456789abcdef.part"};
  for (const char* result : results) here.file(result, "old");
  for (const char* other : others) here.file(other, "mine");
  replace(here.path());
  for (const char* result : results) EXPECT_FALSE(fs::exists(here / result)) << result;
  for (const char* other : others) EXPECT_EQ(file_content(here / other), "mine");
}

TEST(OutputFolder, RemovesNothingBehindALinkAndNoFolder) {
  const TemporaryFolder here;
  fs::create_directories(here / "elsewhere");
  here.file("elsewhere/points_000000.vtp", "mine");
  here.file("elsewhere/history.csv", "mine");
  fs::create_directories(here / "out/shear_strain.png/x");
  fs::create_directory_symlink(here / "elsewhere", here / "out/points");
  fs::create_symlink(here / "elsewhere/history.csv", here / "out/history.csv");
  replace(here / "out");
  EXPECT_EQ(file_content(here / "elsewhere/points_000000.vtp"), "mine");
  EXPECT_EQ(file_content(here / "elsewhere/history.csv"), "mine");
  EXPECT_FALSE(fs::is_symlink(here / "out/history.csv"));
  EXPECT_TRUE(fs::exists(here / "out/shear_strain.png/x"));
  fs::create_directory_symlink(here / "elsewhere", here / "run");
  remove_run(here / "run", "riedel compare");
  EXPECT_EQ(file_content(here / "elsewhere/history.csv"), "mine");
}

TEST(OutputFolder, LosesARunAndStaysWhenItHoldsMore) {
  const TemporaryFolder here;
  for (const char* run : {"alone", "shared"}) {
    fs::create_directories(here / run / "domains");
    for (const char* file : {"case.toml", "summary.json", "domains/domains_000000.vtp"})
      here.file(std::string(run) + "/" + file, "old");
  }
  here.file("shared/notes.txt", "mine");
  for (const char* run : {"alone", "shared"}) remove_run(here / run, "riedel compare");
  EXPECT_FALSE(fs::exists(here / "alone"));
  EXPECT_EQ(file_content(here / "shared/notes.txt"), "mine");
  EXPECT_FALSE(fs::exists(here / "shared/case.toml"));
}

TEST(OutputFolder, IsRefusedWithAFolderInTheWayOfANumber) {
  const TemporaryFolder here;
  fs::create_directory(here / "summary.json");
  expect_refused(here.path(), "summary.json is a folder", true);
}

TEST(OutputFolder, TellsWhyItCannotBeUsed) {
  const TemporaryFolder here;
  const fs::path file = here.file("file", "");
  expect_refused(file, "is a file");
  expect_refused(file / "inside", "cannot be created: Not a directory");
  expect_refused("/proc/self", "cannot be written to"); // exists, and nobody may write there
}
