/// Every command line of the README and of the pages in docs: those in shell blocks are run, with settings that make
/// them quick, and those in the text are at least parsed.
#include "apps/command_help.hpp"
#include "apps/commands.hpp"
#include "apps/program.hpp"
#include "core/base/error.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <sstream>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> pages() {
  std::vector<std::string> all{"README.md"};
  for (const char* folder : {"docs", "docs/howto", "docs/theory"})
    for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / folder))
      if (entry.path().extension() == ".md" && entry.path().filename() != "CHANGELOG.md")
        all.push_back(fs::relative(entry.path(), SOURCE_DIR).string());
  std::ranges::sort(all);
  return all;
}

struct Page {
  std::vector<std::string> commands; ///< of shell blocks, continued lines joined, from "riedel" on
  std::string text;                  ///< outside of blocks
};

Page read_page(const std::string& path) {
  std::istringstream lines(file_content(fs::path(SOURCE_DIR) / path));
  Page page;
  std::string block;
  bool continued = false;
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(' '));
    if (line.starts_with("```")) {
      block = block.empty() ? line : "";
      continue;
    }
    if (block.empty()) page.text += line + "\n";
    if (line.starts_with("build/release/")) line.erase(0, std::string("build/release/").size());
    if (block != "```sh" || (!continued && !line.starts_with("riedel "))) continue;
    if (!continued) page.commands.emplace_back();
    continued = line.ends_with('\\');
    page.commands.back() += continued ? line.substr(0, line.size() - 1) : line;
  }
  return page;
}

/// Code in the text, `like this`, that begins with `beginning`; it may run over the end of a line.
std::vector<std::string> code_in(const std::string& text, const std::string& beginning) {
  std::vector<std::string> found;
  for (const auto& match : matches_in(text, "`(?:build/release/)?(" + beginning + "[^`]*)`"))
    found.push_back(replaced(match[1], "\\s+", " "));
  return found;
}

/// The words as a shell splits them, except for variables and patterns; without comments and redirections.
Words words_of(const std::string& line) {
  Words words;
  bool inside = false;
  char quote = 0;
  for (const char c : line) {
    if (quote == 0 && !inside && (c == '#' || c == '>' || c == '|' || c == '&')) break;
    if (quote == 0 && c == ' ') {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else
      words.back() += c;
  }
  return words;
}

/// That the program knows the command, its options and the names in their lists. An option that stands alone at the
/// end is only mentioned.
void expect_understood(Words words, const std::string& line) {
  if (words.size() < 2 || words[1].starts_with("-") || words[1] == "help") return; // of the program itself
  try {
    const Command& command = find_command(commands(), words[1]);
    const auto mentioned =
        std::ranges::find_if(command.options, [&](const Option& option) { return "--" + option.name == words.back(); });
    if (mentioned != command.options.end() && !mentioned->value.empty()) words.pop_back();
    const Arguments arguments = parse(command, {words.begin() + 2, words.end()});
    if (line.find("plugin") != std::string::npos || line.find("softened") != std::string::npos) return; // user-defined
    for (const Option& option : command.options)
      if (!option.choices.empty() && arguments.has(option.name)) (void)arguments.names(option.name, {}, option.choices);
  } catch (const InputError& error) { ADD_FAILURE() << line << "\n" << error.what(); }
}

/// What makes a command quick, appended to that of the page. Empty: it is not run here, because it takes minutes
/// (reproduce, verify, bench) or needs what another test makes (a campaign, a plug-in, a UMAT, files of another
/// program).
std::string quick(const std::string& line) {
  const auto has = [&](const char* text) { return line.find(text) != std::string::npos; };
  if (has("plugin") || has("library=") || has(" --import ")) return "";
  if (has("--help") || line.starts_with("riedel check") || line.starts_with("riedel list")) return " ";
  if (line.starts_with("riedel compare")) return has("--script") ? " --out campaign" : " --dry-run";
  if (line.starts_with("riedel biaxial"))
    return " --set loading.final_strain=0.0005 --set loading.speed=1 --set output.vtk=false --set output.plots=false "
           "--force --set grid.cells=[4,8]" +
           std::string(has("nonlocal.length") ? "" : " --set nonlocal.length=0");
  if (line.starts_with("riedel element path")) return " --set output.plots=false --force";
  if (line.starts_with("riedel element"))
    return " --set output.plots=false --force --set loading.final_strain=" +
           std::string(has("mpm") ? "0.0005" : "0.01");
  return "";
}

class DocumentedCommands : public testing::Test {
protected:
  DocumentedCommands() {
    fs::create_directory_symlink(SOURCE_DIR "/apps", folder_ / "apps");
    fs::create_directories(folder_ / "docs");
    folder_.file("case.toml", run(folder_, {"check"}).out);
  }
  /// A case of the user, of the kind that the command takes.
  void put_case(const std::string& line) const {
    const bool path = line.starts_with("riedel element path");
    folder_.file("mine.toml", path
                                  ? "test = \"path\"\n[[stage]]\neps_1 = 0.01\nsigma_2 = \"hold\"\nsigma_3 = \"hold\"\n"
                                  : "scheme = \"gimp\"\n[compare]\nschemes = [\"gimp\", \"cpdi\"]\n");
  }
  TemporaryFolder folder_;
};

TEST_F(DocumentedCommands, RunAsTheyStandThere) {
  int count = 0;
  for (const std::string& page : pages())
    for (const std::string& line : read_page(page).commands) {
      expect_understood(words_of(line), page + ": " + line);
      const std::string more = quick(line);
      if (more.empty()) continue;
      put_case(line);
      std::string command = line.substr(0, line.find(" #"));
      const std::size_t sent = std::min(command.find(" >"), command.size());
      command.insert(sent, more);
      const std::string log = (folder_ / "log").string();
      const std::string all = "cd " + folder_.path().string() + " && " RIEDEL_PROGRAM + command.substr(6);
      EXPECT_EQ(std::system(("(" + all + ") >" + log + " 2>&1").c_str()), 0) << page << ": " << line << "\n"
                                                                             << command << "\n"
                                                                             << file_content(log);
      ++count;
    }
  EXPECT_GE(count, 25);
}

TEST_F(DocumentedCommands, AreUnderstoodWhereTheyStandInTheText) {
  int count = 0;
  for (const std::string& page : pages())
    for (const std::string& line : code_in(read_page(page).text, "riedel ")) {
      expect_understood(words_of(line), page + ": " + line);
      ++count;
    }
  EXPECT_GE(count, 20);
}

TEST_F(DocumentedCommands, HaveSettingsThatACaseTakes) {
  int count = 0;
  for (const std::string& page : pages())
    for (const std::string& line : code_in(read_page(page).text, "--set ")) {
      if (line.find("plugin") != std::string::npos || line.find('=') == std::string::npos) continue;
      Words words = words_of("check " + line);
      const bool staged = line.find("stage.") != std::string::npos;
      if (staged) continue; // changes a path, which is a file
      const Outcome outcome = run(folder_, words);
      EXPECT_EQ(outcome.code, 0) << page << ": " << line << "\n" << outcome.err;
      ++count;
    }
  EXPECT_GE(count, 4);
}

} // namespace
} // namespace riedel::test
