/// docs/howto/read_results.md: its tables list exactly the columns and keys that a run writes; the snippets run.
#include "apps/program.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;
using testing::StartsWith;

const std::string& page() {
  static const std::string text = file_content(SOURCE_DIR "/docs/howto/read_results.md");
  return text;
}

/// The names in the first column of the table below a heading.
Names documented(const std::string& heading) {
  std::istringstream text(page().substr(page().find("\n## " + heading + "\n") + 2));
  Names names;
  for (std::string line; std::getline(text, line) && (names.empty() || !line.starts_with("## "));) {
    if (!line.starts_with("| `")) continue;
    std::istringstream cell(line.substr(0, line.find('|', 1)));
    std::string before, name;
    while (std::getline(cell, before, '`') && std::getline(cell, name, '`')) names.insert(name);
  }
  return names;
}

Names columns_of(const fs::path& csv) {
  const std::string text = file_content(csv);
  std::istringstream head(text.substr(0, text.find('\n')));
  Names names;
  for (std::string name; std::getline(head, name, ',');) names.insert(name);
  return names;
}

Names keys_of(const fs::path& json) {
  const auto summary = json_of(json);
  Names names;
  for (const auto& [name, value] : summary.items())
    if (value.is_object())
      for (const auto& inner : value.items()) names.insert(name + "." + inner.key());
    else
      names.insert(name);
  return names;
}

/// The code block of the page in a language.
std::string snippet(const std::string& language) {
  const std::string opening = "```" + language + "\n";
  const std::size_t begin = page().find(opening) + opening.size();
  return page().substr(begin, page().find("```", begin) - begin);
}

class ReadResults : public testing::Test {
protected:
  /// A short run in results/biaxial.
  void run_biaxial(const Words& more = {}) const {
    fs::create_directories(folder_ / "results");
    (void)run(folder_, coarse_case(folder_ / "results/biaxial", more));
  }
  [[nodiscard]] Names run_element(const std::string& test, const std::string& file, const Words& more = {}) const {
    const fs::path out = folder_ / ("element_" + test + std::to_string(more.size()));
    Words words{"element", test, "--out", out.string(), "--set", "output.plots=false"};
    if (test != "path") words.insert(words.end(), {"--set", "loading.final_strain=0.001"});
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(folder_, words).code, 0);
    return file.ends_with(".csv") ? columns_of(out / file) : keys_of(out / file);
  }
  /// Runs a command of the shell in the folder. @return what it prints
  [[nodiscard]] std::string shell(const std::string& command) const {
    const std::string log = (folder_ / "log").string();
    EXPECT_EQ(std::system(("(cd " + folder_.path().string() + " && " + command + ") >" + log + " 2>&1").c_str()), 0)
        << file_content(log);
    return file_content(log);
  }
  TemporaryFolder folder_;
};

bool works(const std::string& command) { return std::system(("(" + command + ") >/dev/null 2>&1").c_str()) == 0; }

/// A Python that has a module; empty: none.
std::string python_with(const std::string& modules) {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (works(std::string(python) + " -c 'import " + modules + "'")) return python;
  return "";
}

} // namespace

TEST_F(ReadResults, ThePageHasTheColumnsOfTheHistoryAndTheKeysOfTheSummary) {
  run_biaxial({"--set", "output.vtk=false", "--set", "output.plots=false"});
  Names known = documented("summary.json of riedel biaxial");
  EXPECT_EQ(documented("history.csv"), columns_of(folder_ / "results/biaxial/history.csv"));
  EXPECT_EQ(known.erase("reason"), 1U) << "only a failed run has one";
  EXPECT_EQ(known, keys_of(folder_ / "results/biaxial/summary.json"));
}

TEST_F(ReadResults, ThePageHasTheKeysOfARunThatFailed) {
  run_biaxial({"--set", "time.step=5e-5", "--set", "loading.final_strain=0.02"});
  const Names keys = keys_of(folder_ / "results/biaxial/summary.json"),
              known = documented("summary.json of riedel biaxial");
  EXPECT_TRUE(keys.contains("reason"));
  for (const std::string& key : keys) EXPECT_TRUE(known.contains(key) || key == "band") << key; // null, not measured
}

TEST_F(ReadResults, ThePageHasTheColumnsAndKeysOfElementTests) {
  Names columns = run_element("triaxial", "element.csv"), keys = run_element("triaxial", "summary.json", {"--force"});
  columns.merge(run_element("shear", "element.csv"));
  keys.merge(run_element("biaxial", "summary.json", {"--driver", "mpm"}));
  const std::string water = folder_.file("water.toml", "[specimen]\nwater_bulk_modulus = 2.2e9\n[[stage]]\n"
                                                       "eps_1 = 1e-4\nsigma_2 = 'hold'\nsigma_3 = 'hold'\n");
  columns.merge(run_element("path", "element.csv", {water}));
  keys.merge(run_element("path", "summary.json", {water, "--force"}));
  EXPECT_EQ(documented("element.csv"), columns);
  EXPECT_EQ(documented("summary.json of riedel element"), keys);
}

TEST_F(ReadResults, TheSnippetOfPandasRuns) {
  const std::string python = python_with("pandas");
  if (python.empty()) GTEST_SKIP() << "python3-pandas is not installed";
  run_biaxial();
  folder_.file("read.py", snippet("python"));
  EXPECT_THAT(shell(python + " read.py"), StartsWith("u_over_h"));
}

TEST_F(ReadResults, TheSnippetOfOctaveRuns) {
  if (!works("octave --version")) GTEST_SKIP() << "octave is not installed";
  run_biaxial();
  folder_.file("read.m", snippet("octave"));
  EXPECT_THAT(shell("octave --no-gui --quiet --norc read.m"), testing::ContainsRegex("^[0-9.]+ deg at u/h0 = 0[.]00"));
}

TEST_F(ReadResults, TheScriptDrawsWithoutADisplay) {
  const std::string python = python_with("matplotlib, vtkmodules.vtkIOXML");
  if (python.empty()) GTEST_SKIP() << "python3-vtk9 or python3-matplotlib is not installed";
  run_biaxial();
  (void)shell("unset DISPLAY; " + python + " " SOURCE_DIR "/docs/howto/draw_fields.py results/biaxial && " + python +
              " " SOURCE_DIR "/docs/howto/draw_fields.py results/biaxial shear_strain shear.png");
  for (const char* picture : {"void_ratio.png", "shear.png"})
    EXPECT_THAT(file_content(folder_ / picture), StartsWith("\x89PNG")) << picture;
}

} // namespace riedel::test
