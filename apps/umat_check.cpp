/// riedel umat-check: checks a UMAT before it is used in a run.
#include "apps/built_in.hpp"
#include "apps/case_help.hpp"
#include "apps/case_kind.hpp"
#include "apps/commands.hpp"
#include "core/base/error.hpp"
#include "core/case/case_text.hpp"
#include "core/case/material_keys.hpp"
#include "core/io/attempt.hpp"
#include "core/io/markdown_table.hpp"
#include "materials/element/umat_probe.hpp"
#include "materials/umat.hpp"

#include <iostream>

namespace riedel {

Keys umat_check_keys() {
  Keys keys{{"material.model", "umat", "", {}, "law of the material", {"umat"}}};
  for (Key key : Umat::parameters()) {
    key.name = "material." + key.name;
    keys.push_back(std::move(key));
  }
  const std::vector<double> stress{-100e3, -100e3, -100e3, 0, 0, 0}, strain{-1e-4, 3e-5, 2e-5, 2e-5, 0, 0};
  keys.push_back({"check.stress", stress, "Pa", {}, "11, 22, 33, 12, 13, 23 at the start"});
  keys.push_back({"check.strain", strain, "-", {}, "increment of strain, engineering shear"});
  keys.push_back(
      {"check.tolerance", 1e-8, "-", more_than(0), "of stress and declared states under rotations, relative"});
  return keys;
}

namespace {

std::string text_of(double x) { return short_text(x, 3); }

/// A line of the report: the check, its result, and what it means.
using Line = TableRow;

/// For the stress, then each state variable: declared ones must agree, others are reported where they do not.
std::vector<Line> rotation_lines(const UmatProbe& probe, double tolerance, bool& good) {
  std::vector<Line> lines;
  for (const Disagreement& found : probe.rotation_errors()) {
    const bool agrees = found.error <= tolerance, first = lines.empty();
    if (agrees && !found.declared) continue;
    good = good && (agrees || !found.declared);
    const std::string verdict = agrees            ? "good"
                                : !found.declared ? "not judged: it has no name in material.state_names"
                                : first ? "BAD: the answer depends on the frame; is a tensor state not declared?"
                                        : "BAD: it depends on the frame";
    lines.push_back({"turned by six rotations: " + found.of, text_of(found.error), verdict});
  }
  return lines;
}

Line speed_line(const UmatProbe& probe) {
  constexpr double slow = 5.0, fast = 20e3; // [m/s]
  const double speed = probe.wave_speed();
  return {"wave speed from DDSDDE [m/s]", text_of(speed),
          speed < slow || speed > fast ? "unlike any soil or rock: is material.stress_unit that of the UMAT?" : ""};
}

Line idle_line(const UmatProbe& probe) {
  const double change = probe.idle_change();
  return {"no strain: change of stress", text_of(change),
          change < 1e-8 ? "" : "the initial stress changes: it creeps, or depends on DFGRD1 alone"};
}

std::vector<Line> halving_lines(const UmatProbe& probe) {
  const std::vector<double> errors = probe.halving_errors();
  std::vector<Line> lines;
  for (std::size_t i = 0; i < errors.size(); ++i)
    lines.push_back({"in " + std::to_string(1 << i) + " steps against " + std::to_string(1 << errors.size()),
                     text_of(errors[i]), ""});
  const double order = std::log2(errors.front() / errors[1]);
  lines.front().back() = errors.front() < 1e-12 || errors[1] == 0.0 ? "the path does not matter"
                                                                    : "order " + text_of(order) + " in the step size";
  return lines;
}

Line stiffness_line(const UmatProbe& probe) {
  const double error = probe.stiffness_error();
  return {"DDSDDE against difference quotients", text_of(error),
          error < 1e-4 ? "the tangent of the step"
                       : "not the tangent; enough for the wave speed if it is a stiffness, in material.stress_unit"};
}

int umat_check(const Arguments& arguments) {
  if (arguments.words.empty()) throw InputError("riedel umat-check needs a library");
  CaseFile given = arguments.case_file(1);
  given.override_with("material.library=" + toml_text(arguments.words.front()), "riedel umat-check:");
  const Values values = checked_case(
                            given, umat_check_keys(), [](const Values&) { return Diagnostics{}; },
                            [&](std::vector<Finding>& errors) {
                              leave_keys_of_runs(given, full_catalogue(), errors);
                              tell_where_keys_are_listed(errors, "umat-check");
                            })
                            .values;
  const Values material = values.section("material");
  try_library(given, values, [&] { const Umat law(material); });
  const UmatProbe probe(material, values.numbers("check.stress"), values.numbers("check.strain"));
  const std::string crash = early_end_of([&] { probe.one_step(); }, "in its first step");
  if (!crash.empty()) throw RunError("umat-check, one step of the strain: the UMAT " + crash);
  probe.one_step();
  bool good = true;
  std::vector<Line> lines{speed_line(probe), idle_line(probe)};
  for (Line& line : rotation_lines(probe, values.number("check.tolerance"), good)) lines.push_back(std::move(line));
  for (Line& line : halving_lines(probe)) lines.push_back(std::move(line));
  lines.push_back(stiffness_line(probe));
  const std::optional<double> copy = probe.copy_difference();
  lines.push_back(
      {"a second copy of the library", copy ? text_of(*copy) : "none",
       copy ? "for a second thread" : "the folder for temporary files takes none: threads wait for each other"});
  lines.push_back({"nanoseconds per call", text_of(probe.nanoseconds()), ""});
  std::cout << markdown_table({"what", "found", ""}, lines, 1);
  if (!good) throw RunError("the UMAT did not pass; see the table");
  return 0;
}

} // namespace

Command umat_check_command() {
  return {.name = "umat-check",
          .usage = "LIB.so [CASE.toml] [options]",
          .summary = "Checks a UMAT: rotated, in smaller steps, and its DDSDDE against difference quotients.",
          .max_words = 2,
          .options = case_options(),
          .run = umat_check,
          .more_help = umat_check_help};
}

} // namespace riedel
