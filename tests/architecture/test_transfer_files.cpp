// What docs/CONTRIBUTING.md says of a new transfer of velocities: a pair of files and one line.
#include "architecture/rules.hpp"

#include <algorithm>
#include <gmock/gmock.h>

namespace riedel::architecture {
namespace {

using testing::UnorderedElementsAre;

/// Files beside the tests that include `header`.
std::vector<std::string> files_that_include(const std::vector<SourceFile>& files, const std::string& header) {
  std::vector<std::string> found;
  for (const SourceFile& file : files)
    if (!file.path.starts_with("tests/") && file.text.find("#include \"" + header + "\"") != std::string::npos)
      found.push_back(file.path);
  return found;
}

TEST(House, KeepsATransferInAPairOfFilesAndALineOfTheRegister) {
  const std::vector<SourceFile> files = read_tree(SOURCE_DIR);
  int transfers = 0;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with("transfers/") || file.path.find('/', 10) != std::string::npos ||
        !file.path.ends_with(".hpp") || file.path.ends_with("/register.hpp"))
      continue;
    ++transfers;
    const std::string stem = file.path.substr(10, file.path.size() - 14);
    std::string name = stem; // Apic of apic.hpp
    name[0] = static_cast<char>(std::toupper(name[0]));
    EXPECT_THAT(files_that_include(files, file.path),
                UnorderedElementsAre("transfers/" + stem + ".cpp", "transfers/register.cpp"));
    const auto text = std::ranges::find(files, std::string("transfers/register.cpp"), &SourceFile::path)->text;
    const std::string line = "  add<" + name + "<Dim>>(transfers,";
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
  EXPECT_GE(transfers, 4);
}

} // namespace
} // namespace riedel::architecture
