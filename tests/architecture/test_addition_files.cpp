// The number of files for a new transfer of velocities and a new element test according to docs/CONTRIBUTING.md.
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

/// Names of element tests, by their files; the biaxial one shares its name with a command.
std::vector<std::string> names_of_element_tests(const std::vector<SourceFile>& files) {
  const std::string folder = "apps/element/tests/";
  std::vector<std::string> names;
  for (const SourceFile& file : files)
    if (file.path.starts_with(folder) && file.path.ends_with(".cpp"))
      names.push_back(file.path.substr(folder.size(), file.path.size() - folder.size() - 4));
  std::erase_if(names, [](const std::string& name) { return name == "test" || name == "tests" || name == "biaxial"; });
  return names;
}

TEST(House, NamesAnElementTestInItsOwnFileAlone) {
  const std::vector<SourceFile> files = read_tree(SOURCE_DIR);
  const std::vector<std::string> names = names_of_element_tests(files);
  EXPECT_GE(names.size(), 3U);
  // Examples of a help text, the test of a case that names none, and the paper's.
  const std::vector<std::string> may{"apps/commands.cpp", "apps/element/keys.hpp",
                                     "apps/reproduce/element_figures.cpp"};
  for (const std::string& name : names)
    for (const SourceFile& file : files) {
      if (file.path.starts_with("tests/") || file.path.starts_with("apps/verify/")) continue; // motions of their own
      if (file.path == "apps/element/tests/" + name + ".cpp") continue;
      if (std::ranges::find(may, file.path) != may.end()) continue;
      EXPECT_EQ(file.text.find('"' + name + '"'), std::string::npos) << file.path << " names " << name;
    }
}

} // namespace
} // namespace riedel::architecture
