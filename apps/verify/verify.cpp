/// riedel verify: problems with known solutions under every scheme, and the orders of convergence.
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/verify/tables.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/marked_document.hpp"
#include "core/io/messages.hpp"
#include "core/io/progress.hpp"
#include "core/run/failure.hpp"
#include "core/run/interrupt.hpp"
#include "core/run/output_folder.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <omp.h>
#include <optional>

namespace riedel {

namespace {

using Names = std::vector<std::string>;
using Studies = std::vector<VerifyStudy>;

Names problem_names() {
  Names names;
  for (const VerifyProblem& problem : verify_problems()) names.push_back(problem.name);
  return names;
}

/// The problem that the pictures show: the square whose points cross cells if it was run, otherwise the first.
const VerifyProblem& drawn(const Studies& studies) {
  for (const VerifyStudy& each : studies)
    if (each.problem->name == "square_crossing") return *each.problem;
  return *studies.front().problem;
}

/// Problem by problem; after an interrupt those completed before.
Studies carry_out(const Catalogue& catalogue, const Names& schemes, const Names& problems, int points,
                  const Interrupt& interrupt) {
  Progress progress("verify");
  Studies studies;
  const double all = static_cast<double>(schemes.size() * problems.size());
  const StudyOptions options{.points = points, .stop = [&] { return static_cast<bool>(interrupt); }};
  try {
    for (const VerifyProblem& problem : verify_problems()) {
      if (std::ranges::find(problems, problem.name) == problems.end()) continue;
      for (const std::string& scheme : schemes) {
        progress.update(static_cast<double>(studies.size()) / all, problem.name + ", " + scheme);
        studies.push_back(study(problem, catalogue, scheme, options));
      }
    }
  } catch (const VerifyStopped&) {} // completed studies are kept
  return studies;
}

void write_results(const Studies& studies, const std::string& status, OutputFolder& output) {
  const std::filesystem::path& folder = output.path();
  const std::string tables = verify_tables(studies);
  output.replace(); // only now, when there are new results
  write_atomically(folder / "verify.md", tables);
  write_atomically(folder / "verify.csv", verify_csv(studies));
  write_atomically(folder / "summary.json", verify_summary(studies, status).dump(2) + "\n");
  std::string pictures;
  try_to_write("the pictures", [&] {
    draw_verify(studies, drawn(studies), folder);
    pictures = ", convergence.png, cost.png";
  });
  std::cout << tables << "\nwritten to " << folder.string() << ": verify.md, verify.csv, summary.json" << pictures
            << "\n";
  for (const VerifyStudy& each : studies)
    if (const std::string missed = each.missed(); !missed.empty())
      print_warning(each.problem->name + " under " + each.scheme + ": " + missed);
}

int verify(const Arguments& arguments) {
  const Catalogue catalogue = load_catalogue(arguments.list("plugin", {})).catalogue;
  const Names all_schemes = catalogue.in_2d.schemes.names(), all_problems = problem_names();
  const Names schemes = arguments.names("schemes", all_schemes, all_schemes);
  const Names problems = arguments.names("problems", all_problems, all_problems);
  const int points = arguments.integer("points", 0, 1, 10);
  std::optional<MarkedDocument> document;
  if (const auto path = arguments.text("document")) document.emplace(*path, "riedel verify");
  const Interrupt interrupt;
  OutputFolder output(arguments.out("results/verify"), arguments.command, arguments.force());
  omp_set_num_threads(1); // small problems; times are those of one thread

  const Studies studies = carry_out(catalogue, schemes, problems, points, interrupt);
  if (!studies.empty()) write_results(studies, interrupt ? "interrupted" : "done", output);
  if (interrupt) return interrupt.exit_code();
  if (document) document->write(verify_tables(studies));
  return 0;
}

Options verify_options() {
  std::vector<std::string> problems;
  for (const VerifyProblem& problem : verify_problems()) problems.push_back(problem.name);
  return {{"schemes", "A,B", "default: all; 'riedel list schemes' lists them", true,
           full_catalogue().in_2d.schemes.names()},
          {"problems", "A,B", "default: all; they are listed below", true, problems},
          {"points", "N", "per cell along each axis; default: the problem's own number, mostly 2"},
          {"out", "DIR", "folder for tables, numbers and pictures; default: results/verify"},
          {"document", "FILE.md", "put the tables between <!-- riedel verify --> and <!-- riedel verify ends -->"},
          {"force", "", "overwrite the results in the folder"},
          plugin_option()};
}

std::string verify_help(const Arguments&) {
  std::string text = "Problems\n";
  for (const VerifyProblem& problem : verify_problems())
    text += "  " + problem.name + ": " + problem.title + "\n    " + problem.measure + "\n    " + problem.source + "\n";
  return text + R"(
Most problems run with cells halved several times, in two dimensions unless stated, with two points per cell along each
axis, MUSL and FLIP, on one thread. The order is the slope of the line through the logarithms of errors and cells. A
warning reports an expected order or error that a scheme misses. verify.md holds the printed tables, verify.csv a line
for each run; convergence.png and cost.png show the square whose points cross cells.

Examples
  riedel verify
  riedel verify --schemes gimp,cpdi --problems bar,vortex --out results/two
)";
}

} // namespace

Command verify_command() {
  return {.name = "verify",
          .usage = "[options]",
          .summary = "Problems with known answers under every scheme: errors, orders of convergence, cost.",
          .max_words = 0,
          .options = verify_options(),
          .run = verify,
          .more_help = verify_help};
}

} // namespace riedel
