/// riedel bench: nanoseconds per point and step, by phase; figures of other programs; limits of the machine.
#include "apps/bench/options.hpp"
#include "apps/bench/peers.hpp"
#include "apps/bench/table.hpp"
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/messages.hpp"
#include "core/io/progress.hpp"
#include "core/run/interrupt.hpp"

#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace riedel {

namespace {

constexpr double storm =
    1e-3; ///< share of points with sub-steps above which a figure reflects these rather than the step

std::string title_of(const BenchCase& c) { return c.scheme + ", " + c.material + ", " + std::to_string(c.points); }

/// The cases that were completed before an interrupt, if any.
std::vector<BenchResult> measure_all(const std::vector<BenchCase>& cases, const Catalogue& catalogue,
                                     const BenchEffort& effort) {
  Progress progress("bench");
  progress.update(0.0, "bare kernel");
  const BareKernelTimes bare = measure_bare_kernel(effort);
  std::vector<BenchResult> results;
  for (const BenchCase& each : cases) {
    progress.update(static_cast<double>(results.size()) / static_cast<double>(cases.size()), title_of(each));
    std::optional<BenchResult> result = measure(each, catalogue, effort);
    if (!result) break;
    if (each.dimension == 2) result->ns_of_bare_kernel = bare.nearest(result->wide, result->points);
    results.push_back(std::move(*result));
  }
  return results;
}

void warn_of_storms(const std::vector<BenchResult>& results) {
  for (const BenchResult& r : results)
    if (r.substepped_share > storm)
      print_warning(title_of(r.of) + ": " + short_text(100 * r.substepped_share) + " % of the points took sub-steps");
}

void write_json(const Arguments& arguments, const nlohmann::ordered_json& json) {
  if (const auto file = arguments.text("json")) write_atomically(*file, json.dump(2) + "\n");
}

/// Checks that the file can be written, before hours of measuring.
void check_json(const Arguments& arguments) {
  const auto file = arguments.text("json");
  if (!file) return;
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(*file).parent_path();
  if (fs::is_directory(*file)) throw InputError("--json " + *file + ": is a folder");
  if (::access(folder.c_str(), W_OK) != 0)
    throw InputError("--json " + *file + ": cannot be written: " + std::strerror(errno));
}

int machine_mode(const Arguments& arguments, const BenchEffort& effort) {
  const MachineLimits limits = measure_machine(effort);
  const BareKernelTimes bare = measure_bare_kernel(effort);
  if (effort.stop()) return 0;
  std::cout << processor_name() << "; this program: " << instruction_set() << "\n\n"
            << machine_tables(limits, bare) << std::flush;
  write_json(arguments, nlohmann::ordered_json::array({machine_json(limits, bare)}));
  return 0;
}

int cases_mode(const Arguments& arguments, const std::vector<BenchCase>& cases, const Catalogue& catalogue,
               const BenchEffort& effort, bool peers) {
  const std::vector<BenchResult> results = measure_all(cases, catalogue, effort);
  nlohmann::ordered_json json = results_json(results);
  if (peers) add_peers(json, results);
  if (results.empty()) {
    write_json(arguments, json);
    return 0;
  }
  std::cout << "Nanoseconds and bytes per point; median of " << effort.repeats << " repeats. " << processor_name()
            << "; bare kernel: " << instruction_set() << "\n\n"
            << (peers ? peers_table(results) : results_table(results))
            << "\nBy phase, ns, measured apart with the clock running\n\n"
            << phases_table(results) << std::flush;
  warn_of_storms(results);
  write_json(arguments, json); // last: the tables are out if it fails
  return 0;
}

int bench(const Arguments& arguments) {
  const bool peers = arguments.has("peers"), machine = arguments.has("machine");
  if (peers && machine) throw InputError("--peers and --machine: one at a time");
  if (peers || machine) refuse_choices(arguments, peers ? "peers" : "machine");
  check_json(arguments);
  const Catalogue catalogue = load_catalogue(arguments.list("plugin", {})).catalogue;
  BenchEffort effort = bench_effort(arguments);
  const std::vector<BenchCase> cases = peers ? peer_cases() : bench_cases(arguments, catalogue);

  const Interrupt interrupt;
  effort.stop = [&] { return static_cast<bool>(interrupt); };
  const int code = machine ? machine_mode(arguments, effort) : cases_mode(arguments, cases, catalogue, effort, peers);
  return interrupt ? interrupt.exit_code() : code;
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

Command bench_command() {
  return {.name = "bench",
          .usage = "[options]",
          .summary = "Nanoseconds per point and step, by phase; figures of other programs; limits of the machine.",
          .max_words = 0,
          .options = bench_options(),
          .run = bench,
          .more_help = bench_help};
}

} // namespace riedel
