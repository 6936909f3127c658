// Files beside a case, and the command line.
#include "apps/biaxial/views.hpp"
#include "apps/command_line.hpp"
#include "apps/element/incremental/driver.hpp"
#include "core/campaign/record.hpp"
#include "core/campaign/results_table.hpp"
#include "core/campaign/run_result.hpp"
#include "core/io/marked_document.hpp"
#include "core/io/table.hpp"
#include "fuzz/support.hpp"
#include "fuzz/targets.hpp"

#include <sstream>

namespace riedel::fuzz {

namespace {

/// With an option of every kind.
const Command& command() {
  static const Command any = [] {
    Command made{"any",  "[CASE.toml] [options]", "", 2, run_options("results"), [](const Arguments&) { return 0; },
                 nullptr};
    made.options.push_back({"schemes", "A,B", ""});
    made.options.push_back({"dry-run", "", ""});
    return made;
  }();
  return any;
}

/// The biaxial test, only for reading its results.
const RunKind kind{.cases = {.name = "biaxial"},
                   .curve_file = "history.csv",
                   .columns = {"step", "time_s", "u_over_h", "phi_mob_deg"},
                   .ascending = {"time_s", "u_over_h"},
                   .check_summary = check_biaxial_summary,
                   .axes = [](const CaseFile&) { return CurveAxes{}; },
                   .outcome = biaxial_outcome};

} // namespace

void campaign(std::string_view input) {
  static const Folder folder;
  folder.file("campaign.json", input);
  may_refuse([&] {
    for (const PlannedRun& run : read_campaign(folder.path(), std::span(&kind, 1)).runs)
      require((folder.path() / run.name).parent_path() == folder.path(), "a run lies outside its campaign");
  });
}

void run_result(std::string_view input) {
  static const Folder folder;
  const auto files = parts(input, 2);
  folder.file("summary.json", files[0]);
  folder.file("history.csv", files[1]);
  folder.file("case.toml", "");
  const PlannedRun run{.name = ".", .label = "run", .settings = {}, .case_text = "", .refusal = ""};
  const std::vector<RunResult> results{result_of(kind, run, folder.path())};
  require(!results_csv(results).empty() && !results_text(kind, results).empty(), "a table without a text");
}

void incremental_driver(std::string_view input) {
  static const Folder folder;
  const auto files = parts(input, 3);
  folder.file("parameters.inp", files[0]);
  folder.file("initialconditions.inp", files[1]);
  folder.file("test.inp", files[2]);
  may_refuse([&] {
    (void)import_incremental_driver(incremental_files({folder.path().string()}), CaseFile::empty()).count("stage");
  });
}

void table(std::string_view input) {
  static const Folder folder;
  const std::filesystem::path path = folder.file("table.csv", input);
  may_refuse([&] {
    const Table read = read_table(path);
    for (const std::string& name : read.names)
      require(read[name].size() == read[read.names.front()].size() && !read[name].empty(), "a column is short");
  });
}

void marked_document(std::string_view input) {
  static const Folder folder;
  const std::filesystem::path path = folder.file("document.md", input);
  may_refuse([&] {
    MarkedDocument(path, "riedel verify").write("a table");
    MarkedDocument(path, "riedel verify").write("another table"); // its lines are still there
  });
}

void command_line(std::string_view input) {
  std::vector<std::string> words;
  std::istringstream stream{std::string(input)};
  for (std::string word; std::getline(stream, word);) words.push_back(word);
  may_refuse([&] {
    const Arguments arguments = parse(command(), words);
    (void)arguments.integer("threads", 1, 1, 1024);
    (void)arguments.names("schemes", {}, {"linear", "gimp"});
    (void)arguments.out("results");
    (void)arguments.with_settings(CaseFile::empty());
  });
}

} // namespace riedel::fuzz
