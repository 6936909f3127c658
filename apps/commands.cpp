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
      {"out", "DIR", "folder for the results; default: results/element/ and the case file's name, or the test's"});
  options.push_back(
      {"driver", "NAME", "what carries the test out; as --set driver.kind=NAME", false, element_driver_names()});
  options.push_back(
      {"vary", "KEY=A,B", "run the case for each value, in a folder each; may be repeated: crossed", true});
  options.push_back({"import", "DIR",
                     "path: take it from parameters.inp, initialconditions.inp and test.inp in DIR; or a file like "
                     "test.inp; param=FILE, ini=FILE or test=FILE for other names; may be repeated",
                     true});
  options.push_back(
      {"threads", "N", "of the mpm driver; or A-B: the program chooses while it runs; default: 1 to all"});
  options.push_back({"reference", "FILE.csv", "show a curve with columns named as in element.csv beside the others"});
  options.push_back({"force", "", "write over the results that the folder holds"});
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
  return {{"schemes", "A,B", "default: all; 'riedel list schemes' names them", true, scheme_names()},
          {"problems", "A,B", "default: all; they are named below", true, problems},
          {"points", "N", "in a cell along each axis; default: the problem's own number, mostly 2"},
          {"out", "DIR", "folder for tables, numbers and pictures; default: results/verify"},
          {"document", "FILE.md", "put the tables between <!-- riedel verify --> and <!-- riedel verify ends -->"},
          {"force", "", "write over the results that the folder holds"},
          plugin_option()};
}

std::string verify_help(const Arguments&) {
  std::string text = "Problems\n";
  for (const VerifyProblem& problem : verify_problems())
    text += "  " + problem.name + ": " + problem.title + "\n    " + problem.measure + "\n    " + problem.source + "\n";
  return text + R"(
Most run with cells halved again and again, in two dimensions unless said, with two points in a cell along each axis,
MUSL and FLIP, on one thread. The order is the slope of the line through the logarithms of errors and cells. A warning
tells what of the expected a scheme misses. verify.md holds the tables that are printed, verify.csv a line for each run;
convergence.png and cost.png show the square whose points cross cells.

Examples
  riedel verify
  riedel verify --schemes gimp,cpdi --problems bar,vortex --out results/two
)";
}

Options compare_options() {
  Options options = case_options();
  std::vector<std::string> schemes = scheme_names();
  schemes.emplace_back("all");
  options.push_back({"schemes", "A,B", "interpolation schemes; 'all' stands for every one there is", true, schemes});
  options.push_back({"vary", "KEY=A,B", "values of a key; may be repeated: all lists are crossed", true});
  options.push_back({"out", "DIR", "folder of the campaign; default: results/ and the name of the case file"});
  options.push_back({"threads", "N", "of all runs together; default: all of the machine"});
  options.push_back({"dry-run", "", "list the runs, with their shares of the work, and start none"});
  options.push_back(
      {"script", "KIND", "start none, and write a script for elsewhere: slurm or parallel", false, script_kinds()});
  options.push_back({"force", "", "remove the campaign that the folder holds, with its runs"});
  return options;
}

std::string compare_help(const Arguments&) {
  return R"(Every combination is a run in a folder of its own, of the biaxial test, or of the element test that the case names
(test = "triaxial"). A run that fails, or cannot begin, is a row that says so. A campaign that was stopped, or killed, goes on
when the same command is given again. results.csv has a row for each run, with every figure of its summary.json; report.html
shows curves, fields and tables in a browser.

A case file can say what is to be varied, and still is a case of its own command:

  [compare]
  title = "Mesh and length"
  schemes = ["gimp", "cpdi"]
  vary = ["grid.cells=[16,56],[24,84]", "nonlocal.length=0,1.5e-3"]

Examples
  riedel compare --schemes gimp,cpdi --vary nonlocal.length=0,1.5mm --dry-run
  riedel compare mine.toml --schemes all --out results/schemes
  riedel compare --set test=triaxial --vary specimen.void_ratio=0.6,0.75,0.9
  riedel compare mine.toml --schemes all --script slurm     then sbatch, and at last: riedel collect results/mine
)";
}

Options reproduce_options() {
  Options options = case_options();
  std::vector<std::string> figures;
  for (const int figure : all_figures) figures.push_back(std::to_string(figure));
  options.push_back({"figure", "N,M", "of 2, 3, 4, 5, 7, 8, 9, 10; default: all", true, figures});
  options.push_back(
      {"way",
       "paper,filtered",
       "the runs as the paper did them; with the stress filter, damped by time, at 0.025 m/s; default: both",
       true,
       {"paper", "filtered"}});
  options.push_back({"scheme", "NAME",
                     "interpolation scheme of Figures 7 to 10; default: gimp as the paper did it, cpdi filtered", false,
                     scheme_names()});
  options.push_back({"out", "DIR", "folder of runs, pictures and report; default: results/reproduce/ and the scheme"});
  options.push_back({"threads", "N", "of all runs together; default: all of the machine"});
  options.push_back(
      {"document", "FILE.md", "put the verdicts between <!-- riedel reproduce --> and <!-- riedel reproduce ends -->"});
  options.push_back({"force", "", "remove the runs that the folder holds, and start anew"});
  return options;
}

std::string reproduce_help(const Arguments&) {
  return R"(The paper is Krzyżanowski, Wójcik and Tejchman (2020). Figures 2 to 5 are element tests at one point; 7 to 10 are runs
of the biaxial test, several at once: three meshes with two time steps each, seven characteristic lengths, three void
ratios, all of them once as the paper did it, and once with the stress filter and slow enough for what follows the peak,
which takes nine tenths of the time. report.html sets every statement of the paper's text beside what was measured both
ways and what theory says. Stopped, or killed, it goes on when the same command is given again.

Examples
  riedel reproduce
  riedel reproduce --figure 8,9 --scheme cpdi
  riedel reproduce --way paper
)";
}

Options list_options() { return {plugin_option()}; }

std::string list_help(const Arguments&) {
  return R"(A name that stands alone is shown whole: what it is, where it comes from, its parameters with unit, default and range,
and of a law its state variables and what it takes averaged.

Examples
  riedel list schemes
  riedel list mohr_coulomb
  riedel list nonlocal.length
  riedel list --plugin build/wu_bauer.so wu_bauer
)";
}

std::string bench_help(const Arguments&) {
  return R"(Lists are crossed: --scheme linear,cpdi --points 1e4,1e5 makes four cases. Each is a block of sand under 100 kPa that
shears and is compressed by 1e-6 in a step. The total is the median of the repeats, without the clock of the phases;
the phases are measured in a repeat of their own. Bytes are what the program holds for the case. "of bare kernel"
is the time over that of a step written out by hand for this machine (2-D, usl, one thread), of the same kind of
scheme and nearest in size: compare it between machines rather than times. Tables are Markdown.

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
       "Element tests: oedometer, triaxial, shear, biaxial, or a path of one's own.", 2, element_options(), element,
       element_help, element_tests()},
      {"compare", "[CASE.toml] [options]",
       "The same case under many schemes and settings, several at once, with a report.", 1, compare_options(), compare,
       compare_help},
      {"collect", "DIR", "The results of a campaign that was run by script, or not to its end.", 1, {}, collect},
      {"reproduce", "[options]", "The paper, figure by figure, with its statements beside what comes out.", 0,
       reproduce_options(), reproduce, reproduce_help},
      {"check", "[CASE.toml] [options]",
       "Checks a case, tells all errors at once, or prints it with every key in force.", 1, check_options(), check,
       check_help},
      {"list", "[schemes|materials|searches|averagers|boundaries|transfers|plugins|NAME ...] [options]",
       "What can be named in a case: everything, a group, or one scheme, law, search, averager, transfer or key whole.",
       100, list_options(), list, list_help, list_words()},
      {"bench", "[options]", "Nanoseconds per point and step, by phase; what peers reach; what the machine can do.", 0,
       bench_options(), bench, bench_help},
      {"verify", "[options]", "Problems with known answers under every scheme: errors, orders of convergence, cost.", 0,
       verify_options(), verify, verify_help},
      {"umat-check", "LIB.so [CASE.toml] [options]",
       "What a UMAT does: turned, in smaller steps, its DDSDDE against difference quotients.", 2, case_options(),
       umat_check, umat_check_help},
  };
  return all;
}

} // namespace riedel
