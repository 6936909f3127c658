/// Files that a user names as input.
#include "core/base/error.hpp"
#include "core/case/case_file.hpp"
#include "core/io/input_file.hpp"
#include "core/io/table.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class InputFiles : public testing::Test {
protected:
  /// The message of every reader about a file.
  static void expect_refused(const std::string& path, const std::string& why) {
    const auto says =
        testing::ThrowsMessage<InputError>(AllOf(StartsWith(path + ": cannot be read: "), HasSubstr(why)));
    EXPECT_THAT([&] { (void)read_input_file(path); }, says);
    EXPECT_THAT([&] { (void)CaseFile::read(path); }, says);
    EXPECT_THAT([&] { (void)read_table(path); }, says);
  }
  TemporaryFolder folder_;
};

TEST_F(InputFiles, AreReadWholeWithEveryByte) {
  const std::string text("a\0b\r\n\xff", 6);
  EXPECT_EQ(read_input_file(folder_.file("bytes", text)), text);
  EXPECT_EQ(read_input_file(folder_.file("empty", "")), "");
}

TEST_F(InputFiles, ThatNeverEndAreRefused) {
  expect_refused("/dev/zero", "is not a regular file");
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_refused(pipe, "is not a regular file"); // without a writer: opening it would wait for ever
}

TEST_F(InputFiles, ThatAreTooLargeAreRefused) {
  const std::string hole = folder_.file("hole", "");
  std::filesystem::resize_file(hole, std::uintmax_t{1} << 40); // takes no room on the disk
  expect_refused(hole, "is too large; allowed: at most 64 MiB");
  EXPECT_THAT([&] { (void)read_input_file(folder_.file("four", "1234"), 3); },
              testing::ThrowsMessage<InputError>(HasSubstr("allowed: at most 3 bytes")));
  EXPECT_EQ(read_input_file(folder_.file("three", "123"), 3), "123");
}

TEST_F(InputFiles, ThatAreNoneSayWhy) {
  expect_refused((folder_ / "none").string(), "No such file or directory");
  expect_refused(folder_.path().string(), "is a folder");
  expect_refused("/proc/self/mem", "Input/output error"); // opens, but its first byte cannot be read
}

} // namespace
} // namespace riedel::test
