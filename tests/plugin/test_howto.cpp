/// The commands of the pages for plug-in authors, as written there, with short runs.
#include "plugin/plugins.hpp"
#include "support/patterns.hpp"

#include <sstream>

namespace riedel::test {
namespace {

/// Lines of a page's shell blocks that start the program, with continued lines joined.
std::vector<std::string> program_lines(const std::string& page) {
  std::istringstream text(file_content(SOURCE_DIR "/" + page));
  std::vector<std::string> lines;
  bool shell = false, continued = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) shell = line == "```sh";
    if (line.starts_with("build/release/")) line.erase(0, std::string("build/release/").size());
    if (!shell) continue;
    const std::string before = continued ? lines.back() : "";
    if (!continued && !line.starts_with("riedel ")) continue;
    if (continued) lines.pop_back();
    continued = line.ends_with('\\');
    lines.push_back(before + (continued ? line.substr(0, line.size() - 1) : line));
  }
  return lines;
}

/// The command with settings that make it quick.
std::string shortened(const std::string& line) {
  std::string quick = std::string(RIEDEL_PROGRAM) + line.substr(std::string("riedel").size());
  if (line.starts_with("riedel biaxial"))
    quick +=
        " --set grid.cells=[8,28] --set loading.final_strain=0.0005 --set loading.speed=0.4 --set output.vtk=false "
        "--set output.plots=false --force";
  if (line.starts_with("riedel element")) quick += " --set output.plots=false --set loading.final_strain=0.01 --force";
  if (line.starts_with("riedel verify")) quick += " --problems bar --force";
  if (line.starts_with("riedel bench")) quick += " --points 500 --repeats 1 --seconds 0.001";
  return quick;
}

class Howto : public testing::TestWithParam<std::string> {};

TEST_P(Howto, HasCommandsThatRun) {
  const bool fortran = std::filesystem::exists(example("elastic_umat"));
  if (!fortran && GetParam() == "docs/howto/use_a_umat.md") GTEST_SKIP() << "no Fortran compiler was found";
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(PLUGINS "/examples", folder / "build");
  if (fortran) std::filesystem::copy_file(example("elastic_umat"), folder / "mine.so");
  std::filesystem::copy_file(example("wu_bauer"), folder / "my_law.so");
  std::vector<std::string> lines = program_lines(GetParam());
  if (GetParam() == "README.md") { // the other lines are those of tests/apps
    std::erase_if(lines, [&](const std::string& line) {
      return line.find(".so") == std::string::npos || (!fortran && line.find("umat") != std::string::npos);
    });
    for (std::string& line : lines) line = replaced(line, "model=my_law", "model=wu_bauer");
  }
  EXPECT_GE(lines.size(), fortran ? 2U : 1U);
  for (const std::string& line : lines) {
    const std::string command = "cd " + folder.path().string() + " && " + shortened(line) + " >log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << line << "\n" << file_content(folder / "log");
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Howto,
                         testing::Values("README.md", "docs/howto/write_a_material.md", "docs/howto/write_a_scheme.md",
                                         "docs/howto/add_a_transfer.md", "docs/howto/use_a_umat.md"),
                         [](const auto& tested) { return std::filesystem::path(tested.param).stem().string(); });

} // namespace
} // namespace riedel::test
