/// riedel biaxial: the plane strain compression test, from a case to numbers, files for ParaView and pictures.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/memory_needed.hpp"
#include "apps/biaxial/pictures.hpp"
#include "apps/biaxial/report.hpp"
#include "apps/built_in.hpp"
#include "apps/case_help.hpp"
#include "apps/commands.hpp"
#include "core/base/thread_choice.hpp"
#include "core/case/case_text.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/figure_json.hpp"
#include "core/io/json_text.hpp"
#include "core/io/messages.hpp"
#include "core/io/progress.hpp"
#include "core/run/failure.hpp"
#include "core/run/interrupt.hpp"
#include "core/run/output_folder.hpp"
#include "core/run/threads.hpp"

#include <cstdio>
#include <iostream>

namespace riedel {

namespace {

void write_summary(const std::filesystem::path& folder, nlohmann::ordered_json summary) {
  write_atomically(folder / "summary.json", json_text(summary));
}

void print_result(const nlohmann::ordered_json& summary, const std::filesystem::path& folder,
                  const std::vector<std::string>& pictures) {
  std::cout << biaxial_text(summary) << "written to " << folder.string() << ": case.toml, history.csv, summary.json";
  for (const std::string& name : pictures) std::cout << ", " << name;
  std::cout << std::endl;
}

/// Records the failure of a run that did not begin in its summary, if that can still be written.
void write_failure(const std::filesystem::path& folder, const std::string& reason) {
  if (std::filesystem::exists(folder / "summary.json")) return; // it contains more
  try {
    write_summary(folder, {{"case", "biaxial"}, {"version", version()}, {"status", "failed"}, {"reason", reason}});
  } catch (const RunError& another) { print_warning(another.what()); }
}

template <int Dim>
void advance(BiaxialRun<Dim>& run, const BiaxialCase& values, const Interrupt& interrupt) {
  Progress progress("biaxial");
  run.advance([&] { return static_cast<bool>(interrupt); },
              [&](const BiaxialRow& row) {
                std::array<char, 48> note{};
                std::snprintf(note.data(), note.size(), "u/h0 = %.2f %%, phi = %.1f deg", 100 * row.u_over_h,
                              row.angle);
                progress.update(row.u_over_h / values.loading.final_strain, note.data());
              });
}

/// Warns of results that are not reliable.
template <int Dim>
void warn_of_doubts(const BiaxialRun<Dim>& run, const nlohmann::ordered_json& summary) {
  for (const auto& [part, name] : {std::pair{"band", "shear band: "}, {"stress", "stresses: "}})
    if (const std::string doubt = text_in(summary.at(part), "doubt", ""); !doubt.empty()) print_warning(name + doubt);
  if (const std::string doubt = run.time_step().doubt(); !doubt.empty()) print_warning(doubt);
  if (run.kinetic_over_internal() > quasi_static_limit)
    print_warning("the run is not quasi-static: kinetic energy reached " + short_text(run.kinetic_over_internal()) +
                  " of the internal energy; use a smaller loading.speed");
}

/// What a run is to do.
struct Order {
  CheckedCase given;
  BiaxialCase test;
  Catalogue catalogue;
  ThreadRange threads;
};

/// How far a run has come: not begun, begun, or reported in its final summary, which is not replaced any more.
enum class Stage { before, begun, reported };

/// Runs the case and writes its results; earlier ones are replaced only when it can begin. @return the exit code
template <int Dim>
int run_case(const Order& order, OutputFolder& output, Stage& stage) {
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  const BiaxialCase& values = order.test;
  require_threads(order.threads.maximum);
  ThreadChoice threads(order.threads);
  BiaxialRun<Dim> run(values, order.catalogue, output.path(), [&](const auto& step) { threads.step(step); });
  output.replace();
  stage = Stage::begun;
  write_atomically(output.path() / "case.toml", case_text(order.given.keys, order.given.values));
  run.begin();
  const auto ending = [&](const std::string& status, const std::string& reason = "") {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return BiaxialEnding{status, reason, wall.count(), threads.max_used(), run.time_step().maximum()};
  };
  try {
    advance(run, values, interrupt);
  } catch (const std::exception& failure) {
    try_to_write("the summary", [&] {
      const nlohmann::ordered_json result = biaxial_summary(run, values, ending("failed", reason_of(failure)));
      write_summary(output.path(), result);
      stage = Stage::reported;
      print_result(result, output.path(), {});
    });
    throw;
  }
  const nlohmann::ordered_json result = biaxial_summary(run, values, ending(interrupt ? "interrupted" : "done"));
  write_summary(output.path(), result);
  stage = Stage::reported;
  std::vector<std::string> pictures;
  if (values.output.plots)
    try_to_write("the pictures", [&] { pictures = draw_biaxial(run.rows(), run.section(), values, output.path()); });
  print_result(result, output.path(), pictures);
  warn_of_doubts(run, result);
  return interrupt ? interrupt.exit_code() : 0;
}

/// Runs the case. Any failure is recorded in the summary, unless that would replace the results of another run.
int run_to_some_end(const Order& order, OutputFolder& output) {
  Stage stage = Stage::before;
  try {
    const bool slab = order.test.grid.dimensions == 3;
    return (slab ? run_case<3> : run_case<2>)(order, output, stage);
  } catch (const std::exception& error) {
    const bool wrong_input =
        dynamic_cast<const InputError*>(&error) != nullptr || dynamic_cast<const PluginError*>(&error) != nullptr;
    const bool unseen = stage == Stage::before && !wrong_input && output.is_fresh();
    if (stage == Stage::begun || unseen) write_failure(output.path(), reason_of(error));
    rethrow_as_failure();
  }
}

int biaxial(const Arguments& arguments) {
  const CaseFile file = arguments.case_file().without("compare"); // a study also serves as the case that it varies
  Catalogue catalogue = load_catalogue(file).catalogue;
  CheckedCase given = biaxial_case(file, catalogue);
  for (const std::string& note : given.notes) print_note(note);
  for (const std::string& warning : given.warnings) print_warning(warning);
  BiaxialCase test(given.values);
  require_memory(test, catalogue, file);
  const Order order{std::move(given), std::move(test), std::move(catalogue), arguments.threads()};
  OutputFolder output(arguments.out("results/biaxial"), arguments.command, arguments.force());
  return run_to_some_end(order, output);
}

} // namespace

Command biaxial_command() {
  return {.name = "biaxial",
          .usage = "[CASE.toml] [options]",
          .summary = "Plane strain compression of a sand specimen; the paper's case when none is given.",
          .max_words = 1,
          .options = run_options("results/biaxial"),
          .run = biaxial,
          .more_help = biaxial_help};
}

} // namespace riedel
