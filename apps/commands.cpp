#include "apps/commands.hpp"

#include "apps/bench/options.hpp"
#include "apps/built_in.hpp"
#include "apps/case_help.hpp"
#include "apps/element/drivers.hpp"
#include "apps/element/keys.hpp"
#include "apps/reproduce/paper_runs.hpp"
#include "apps/verify/problem.hpp"
#include "core/campaign/script.hpp"

namespace riedel {

namespace {

std::vector<std::string> scheme_names() { return full_catalogue().in_2d.schemes.names(); }

Options element_options() {
  Options options = case_options();
  options.push_back(
      {"out", "DIR", "folder for the results; default: results/element/ and the name of the case file or test"});
  options.push_back(
      {"driver", "NAME", "what runs the test; same as --set driver.kind=NAME", false, element_driver_names()});
  options.push_back({"vary", "KEY=A,B",
                     "run the case for each value, each in its own folder; if repeated, for all combinations", true});
  options.push_back({"import", "DIR",
                     "path: read it from parameters.inp, initialconditions.inp and test.inp in DIR; or a file like "
                     "test.inp; param=FILE, ini=FILE or test=FILE for other names; may be repeated",
                     true});
  options.push_back(
      {"threads", "N", "for the mpm driver; or A-B: the program chooses while it runs; default: 1 to all"});
  options.push_back({"reference", "FILE.csv", "show a curve with columns named as in element.csv beside the others"});
  options.push_back({"force", "", "overwrite the results in the folder"});
  return options;
}

Options check_options() {
  Options options = case_options();
  options.push_back({"schema", "", "print a JSON Schema of the case, for editors"});
  options.push_back({"reference", "", "print the reference of all keys as Markdown"});
  return options;
}

Options verify_options() {
  std::vector<std::string> problems;
  for (const VerifyProblem& problem : verify_problems()) problems.push_back(problem.name);
  return {{"schemes", "A,B", "default: all; 'riedel list schemes' lists them", true, scheme_names()},
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

Options compare_options() {
  Options options = case_options();
  std::vector<std::string> schemes = scheme_names();
  schemes.emplace_back("all");
  options.push_back({"schemes", "A,B", "interpolation schemes; 'all' stands for all of them", true, schemes});
  options.push_back({"vary", "KEY=A,B", "values of a key; if repeated, all combinations are run", true});
  options.push_back({"out", "DIR", "folder of the campaign; default: results/ and the name of the case file"});
  options.push_back({"threads", "N", "for all runs together; default: all of the machine"});
  options.push_back({"dry-run", "", "list the runs, with their shares of the work, and start none"});
  options.push_back({"script", "KIND", "start none, but write a script to run them elsewhere: slurm or parallel", false,
                     script_kinds()});
  options.push_back({"force", "", "remove the campaign in the folder, with its runs"});
  return options;
}

std::string compare_help(const Arguments&) {
  return R"(Every combination is a run in its own folder, of the biaxial test or of the element test that the case names
(test = "triaxial"). The row of a run that fails or cannot begin says so. A campaign that was stopped or killed
continues when the same command is given again. results.csv has a row for each run, with every value of its
summary.json; report.html shows curves, fields and tables in a browser.

A case file can state what is varied, and still be run as a single case:

  [compare]
  title = "Mesh and length"
  schemes = ["gimp", "cpdi"]
  vary = ["grid.cells=[16,56],[24,84]", "nonlocal.length=0,1.5e-3"]

Examples
  riedel compare --schemes gimp,cpdi --vary nonlocal.length=0,1.5mm --dry-run
  riedel compare mine.toml --schemes all --out results/schemes
  riedel compare --set test=triaxial --vary specimen.void_ratio=0.6,0.75,0.9
  riedel compare mine.toml --schemes all --script slurm     then sbatch, and finally: riedel collect results/mine
)";
}

Options reproduce_options() {
  Options options = case_options();
  std::vector<std::string> figures;
  for (const int figure : all_figures) figures.push_back(std::to_string(figure));
  options.push_back({"figure", "N,M", "of 2, 3, 4, 5, 7, 8, 9, 10; default: all", true, figures});
  options.push_back({"way",
                     "paper,filtered",
                     "paper: the runs as in the paper; filtered: with the stress filter, damping by time, at 0.025 "
                     "m/s; default: both",
                     true,
                     {"paper", "filtered"}});
  options.push_back({"scheme", "NAME",
                     "interpolation scheme of Figures 7 to 10; default: gimp for paper, cpdi for filtered", false,
                     scheme_names()});
  options.push_back({"out", "DIR", "folder of runs, pictures and report; default: results/reproduce/ and the scheme"});
  options.push_back({"threads", "N", "for all runs together; default: all of the machine"});
  options.push_back(
      {"document", "FILE.md", "put the verdicts between <!-- riedel reproduce --> and <!-- riedel reproduce ends -->"});
  options.push_back({"force", "", "remove the runs in the folder, and start again"});
  return options;
}

std::string reproduce_help(const Arguments&) {
  return R"(The paper is Krzyżanowski, Wójcik and Tejchman (2020). Figures 2 to 5 are element tests at one point; 7 to 10 are runs
of the biaxial test, several at once: three meshes with two time steps each, seven characteristic lengths, three void
ratios. All are run once as in the paper, and once with the stress filter and slowly enough for the behaviour after the
peak, which takes nine tenths of the time. report.html compares every statement of the paper's text with both results
and with theory. A command that was stopped or killed continues when it is given again.

Examples
  riedel reproduce
  riedel reproduce --figure 8,9 --scheme cpdi
  riedel reproduce --way paper
)";
}

Options list_options() { return {plugin_option()}; }

std::string list_help(const Arguments&) {
  return R"(A single name is shown in full: what it is, its source, its parameters with unit, default and range, and
for a law its state variables and the variables that it can take averaged.

Examples
  riedel list schemes
  riedel list mohr_coulomb
  riedel list nonlocal.length
  riedel list --plugin build/wu_bauer.so wu_bauer
)";
}

std::string bench_help(const Arguments&) {
  return R"(All combinations are run: --scheme linear,cpdi --points 1e4,1e5 makes four cases. Each is a block of sand
under 100 kPa that is sheared and compressed by 1e-6 per step. The total is the median of the repeats, without the phase
clock; the phases are measured in a separate repeat. Bytes are the memory in use for the case. "of bare kernel" is the
time divided by that of a hand-written step on this machine (2-D, usl, one thread), for the same kind of scheme and the
nearest size: between machines, compare this ratio rather than times. Tables are Markdown.

Examples
  riedel bench --scheme linear,gimp,cpgimp,cpdi --points 1e5
  riedel bench --length 0,1.5mm --search cgal_kd_tree,cell_list --points 1e4 --threads 1,2 --json bench.json
  riedel bench --peers
  riedel bench --machine
)";
}

} // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"biaxial", "[CASE.toml] [options]",
       "Plane strain compression of a sand specimen; the paper's case when none is given.", 1,
       run_options("results/biaxial"), biaxial, biaxial_help},
      {"element", "TEST [CASE.toml] [options]",
       "Element tests: oedometer, triaxial, shear, biaxial, or a user-defined path.", 2, element_options(), element,
       element_help, element_tests()},
      {"compare", "[CASE.toml] [options]",
       "The same case under many schemes and settings, several at once, with a report.", 1, compare_options(), compare,
       compare_help},
      {"collect", "DIR", "Collects the results of a campaign that was run by script or not completed.", 1, {}, collect},
      {"reproduce", "[options]", "Reproduces the paper figure by figure, and compares its statements with the results.",
       0, reproduce_options(), reproduce, reproduce_help},
      {"check", "[CASE.toml] [options]",
       "Checks a case: reports all errors at once, or prints the case with every key in force.", 1, check_options(),
       check, check_help},
      {"list", "[schemes|materials|searches|averagers|boundaries|transfers|plugins|NAME ...] [options]",
       "Lists what a case can name: everything, a group, or one scheme, law, search, averager, transfer or key in "
       "full.",
       100, list_options(), list, list_help, list_words()},
      {"bench", "[options]",
       "Nanoseconds per point and step, by phase; figures of other programs; limits of the machine.", 0,
       bench_options(), bench, bench_help},
      {"verify", "[options]", "Problems with known answers under every scheme: errors, orders of convergence, cost.", 0,
       verify_options(), verify, verify_help},
      {"umat-check", "LIB.so [CASE.toml] [options]",
       "Checks a UMAT: rotated, in smaller steps, and its DDSDDE against difference quotients.", 2, case_options(),
       umat_check, umat_check_help},
  };
  return all;
}

} // namespace riedel
