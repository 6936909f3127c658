/// riedel element: oedometer, triaxial, shear, biaxial, or a user-defined path, at one point or more.
#include "apps/built_in.hpp"
#include "apps/case_help.hpp"
#include "apps/commands.hpp"
#include "apps/element/drivers.hpp"
#include "apps/element/earlier_variants.hpp"
#include "apps/element/incremental/driver.hpp"
#include "apps/element/incremental/output.hpp"
#include "apps/element/keys.hpp"
#include "apps/element/path.hpp"
#include "apps/element/pictures.hpp"
#include "apps/element/summary.hpp"
#include "apps/element/tests/tests.hpp"
#include "core/base/error.hpp"
#include "core/campaign/legend.hpp"
#include "core/case/case_text.hpp"
#include "core/case/vary.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/history.hpp"
#include "core/io/json_text.hpp"
#include "core/io/messages.hpp"
#include "core/run/failure.hpp"
#include "core/run/interrupt.hpp"
#include "core/run/output_folder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace riedel {

namespace {

/// One of the cases that a command runs.
struct ElementRun {
  Variant variant;
  CheckedCase checked;
  ElementCase given;
  std::filesystem::path folder;
};

std::string test_named(const Arguments& arguments) {
  if (arguments.words.empty()) {
    std::string known;
    for (const std::string& test : element_tests()) known += (known.empty() ? "" : ", ") + test;
    throw InputError("riedel element needs a test: " + known);
  }
  refuse_unknown_names("element test", {arguments.words.front()}, element_tests());
  return arguments.words.front();
}

/// The case file, or the one that --import makes.
CaseFile given_file(const Arguments& arguments, const std::string& test) {
  if (!arguments.has("import")) return arguments.case_file(1);
  if (test != "path" || arguments.words.size() > 1)
    throw InputError("--import gives the whole case of 'riedel element path', without another test or a case file");
  const IncrementalFiles files = incremental_files(arguments.options.find("import")->second);
  return arguments.with_settings(import_incremental_driver(files, arguments.with_settings(CaseFile::empty())));
}

/// The case under the test that the command line names.
CaseFile given_case(const Arguments& arguments, const std::string& test) {
  CaseFile given = given_file(arguments, test);
  if (const auto wish = test_of(given); wish && *wish != test)
    throw InputError(given.place("test") + ": is \"" + *wish + "\", and the command asks for " + test);
  given.override_with("test=" + test, "riedel element:");
  if (const auto driver = arguments.text("driver")) given.override_with("driver.kind=" + *driver, "--driver:");
  return given;
}

std::vector<ElementRun> runs_of(const Arguments& arguments, const std::string& test, const Catalogue& catalogue,
                                const std::filesystem::path& folder) {
  const auto wishes = arguments.options.find("vary");
  const std::vector<Variation> variations =
      wishes == arguments.options.end() ? std::vector<Variation>{} : variations_of(wishes->second);
  std::vector<ElementRun> runs;
  std::vector<NamedCase> cases;
  for (Variant& variant : variants_of(given_case(arguments, test), variations)) {
    CheckedCase checked = element_case(variant.given, catalogue);
    const std::filesystem::path place = variant.name.empty() ? folder : folder / variant.name;
    cases.push_back({variant.name, case_text(checked.keys, checked.values)});
    const ElementCase given(checked.values);
    runs.push_back({std::move(variant), std::move(checked), given, place});
  }
  refuse_same_cases(cases);
  return runs;
}

nlohmann::ordered_json summary_head(const ElementRun& run) {
  return {{"case", "element"},
          {"test", run.given.test},
          {"version", version()},
          {"driver", run.given.driver.kind},
          {"material", run.given.material.model}};
}

void write_summary(const ElementRun& run, const ElementCurve& curve, double wall) {
  nlohmann::ordered_json all = summary_head(run);
  all.update(element_summary(curve));
  all["wall_s"] = wall;
  write_atomically(run.folder / "summary.json", json_text(all));
}

/// What all runs of a command share.
struct Manner {
  const Catalogue& catalogue;
  const Interrupt& interrupt;
  bool imported;
  ThreadRange threads;
};

/// Runs one case and writes case.toml, element.csv and summary.json to its folder, and output.txt for an imported one.
ElementCurve carry_out(const ElementRun& run, const Manner& manner) {
  const ElementCase& given = run.given;
  const bool shear = shears(given.test);
  write_atomically(run.folder / "case.toml", case_text(run.checked.keys, run.checked.values));
  const auto start = std::chrono::steady_clock::now();
  const PoreWater water = element_path(given).water;
  History history(run.folder / "element.csv", element_columns(shear, water.present()));
  std::optional<IncrementalOutput> output;
  const auto write_row = [&](const ElementRow& row, const MaterialPoint& point) {
    history.add(element_numbers(row, shear, water.present()));
    if (manner.imported && !output)
      output.emplace(run.folder / "output.txt",
                     *manner.catalogue.materials.find(given.material.model).make(given.material.parameters), water,
                     given.material.parameters);
    if (output) output->add(point);
  };
  const ElementWatch watch{
      .at_row = write_row, .stop = [&] { return static_cast<bool>(manner.interrupt); }, .threads = manner.threads};
  ElementCurve curve = element_driver(given).run(given, manner.catalogue, watch);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  write_summary(run, curve, wall.count());
  return curve;
}

/// The same; an exception is recorded in the summary before it is passed on.
ElementCurve carry_out_safely(const ElementRun& run, const Manner& manner) {
  try {
    return carry_out(run, manner);
  } catch (const std::exception& error) {
    nlohmann::ordered_json all = summary_head(run);
    all["status"] = "failed";
    all["reason"] = reason_of(error);
    try_to_write("the summary", [&] { write_atomically(run.folder / "summary.json", all.dump(2) + "\n"); });
    rethrow_as_failure();
  }
}

void print_result(const NamedCurve& named) {
  const ElementCurve& curve = named.curve;
  const auto peak = std::ranges::max_element(curve.rows, {}, &ElementRow::phi_mob);
  const ElementRow& last = curve.rows.back();
  const bool shear = shears(curve.test);
  const char* how = !curve.failure.empty() ? "failed: " : !curve.interrupted.empty() ? "interrupted: " : "";
  std::printf("%s%s%speak %.2f deg at %s = %.2f %%, end %.2f deg, e = %.4f, sigma_1 = %.4g kPa at %.2f %%\n",
              named.label.c_str(), named.label.empty() ? "" : ": ", how, peak->phi_mob, shear ? "gamma" : "eps_1",
              100 * (shear ? peak->gamma : peak->eps[0]), last.phi_mob, last.void_ratio, 1e-3 * last.sigma[0],
              100 * (shear ? last.gamma : last.eps[0]));
}

/// What follows the test's name in a title: the law, and the void ratio and the pressure unless they are varied.
std::string subject_of(const ElementRun& run) {
  const Values& values = run.checked.values;
  const auto fixed = [&](const std::string& key) {
    return values.has(key) && run.variant.label.find(key.substr(key.rfind('.') + 1)) == std::string::npos;
  };
  std::string subject = ", " + run.given.material.model;
  if (fixed("specimen.void_ratio")) subject += ", e₀ = " + short_text(run.given.void_ratio);
  for (const auto& [key, symbol] : {std::pair{"loading.confining_pressure", "σ_c"}, {"loading.normal_stress", "σ_n"}})
    if (fixed(key)) subject += std::string(", ") + symbol + " = " + short_text(1e-3 * values.number(key)) + " kPa";
  return subject;
}

/// The message of a command that was interrupted.
void print_interruption(const std::vector<NamedCurve>& curves, std::size_t runs) {
  const auto& [label, curve] = curves.back();
  const ElementRow& last = curve.rows.back();
  std::string text = "interrupted";
  if (!curve.interrupted.empty())
    text += std::string(label.empty() ? "" : " at " + label) + " in " + curve.interrupted + ", at " +
            (shears(curve.test) ? "gamma = " + short_text(100.0 * last.gamma, 4)
                                : "eps_1 = " + short_text(100.0 * last.eps[0], 4)) +
            " % and " + short_text(last.time, 4) + " s";
  if (runs > 1)
    text += "; " + std::to_string(curves.size() - (curve.interrupted.empty() ? 0 : 1)) + " of " + std::to_string(runs) +
            " runs are complete";
  print_warning(text);
}

void print_files(const std::filesystem::path& folder, bool several, const std::vector<std::string>& pictures) {
  std::printf("written to %s: %scase.toml, element.csv, summary.json", folder.c_str(), several ? "folders with " : "");
  for (const std::string& name : pictures) std::printf(", %s", name.c_str());
  std::printf("\n");
}

/// results/element and the name of the case file, if any, otherwise of the test.
std::filesystem::path standard_folder(const Arguments& arguments, const std::string& test) {
  const std::string name = arguments.words.size() > 1 ? std::filesystem::path(arguments.words[1]).stem().string() : "";
  return std::filesystem::path("results/element") / (name.empty() ? test : name);
}

std::filesystem::path input_of(const Arguments& arguments) {
  return arguments.words.size() > 1 ? arguments.words[1] : "";
}

int element(const Arguments& arguments) {
  const std::string test = test_named(arguments);
  const Catalogue catalogue = load_catalogue(given_file(arguments, test)).catalogue;
  const std::filesystem::path folder = arguments.out(standard_folder(arguments, test));
  const ThreadRange threads = arguments.threads();
  const std::vector<ElementRun> runs = runs_of(arguments, test, catalogue, folder);
  std::optional<Overlay> overlay;
  if (const auto path = arguments.text("reference")) overlay = read_overlay(*path, test);

  OutputFolder output(folder, arguments.command, arguments.force());
  const EarlierVariants earlier(folder, arguments.force());
  for (const ElementRun& run : runs)
    if (run.folder != folder) const OutputFolder can_be_had(run.folder, arguments.command, arguments.force());
  const Interrupt interrupt;
  const Manner manner{catalogue, interrupt, arguments.has("import"), threads};
  output.replace();
  earlier.remove(arguments.command, input_of(arguments), runs.front().folder != folder);
  std::vector<NamedCurve> curves;
  int code = 0;
  for (const ElementRun& run : runs) {
    std::optional<OutputFolder> of_run;
    if (run.folder != folder) of_run.emplace(run.folder, arguments.command, arguments.force()).replace();
    curves.push_back({run.variant.label, carry_out_safely(run, manner)});
    const ElementCurve& curve = curves.back().curve;
    print_result(curves.back());
    if (!curve.failure.empty()) {
      print_error((run.variant.label.empty() ? "" : run.variant.label + ": ") + curve.failure);
      code = 3;
    }
    if (interrupt) break;
  }
  std::vector<std::string> pictures;
  for (std::size_t i = 0; i < curves.size(); ++i)
    curves[i].label = legend_label(runs[i].variant.settings, runs[i].checked.keys);
  if (runs.front().given.plots)
    try_to_write("the pictures", [&] { pictures = draw_element(curves, overlay, subject_of(runs.front()), folder); });
  print_files(folder, runs.front().folder != folder, pictures);
  if (interrupt) print_interruption(curves, runs.size());
  return interrupt ? interrupt.exit_code() : code;
}

Options element_options() {
  Options options = case_options();
  const Options own{
      {"out", "DIR", "folder for the results; default: results/element/ and the name of the case file or test"},
      {"driver", "NAME", "what runs the test; same as --set driver.kind=NAME", false, element_driver_names()},
      {"vary", "KEY=A,B", "run the case for each value, each in its own folder; if repeated, for all combinations",
       true},
      {"import", "DIR",
       "path: read it from parameters.inp, initialconditions.inp and test.inp in DIR; or a file like test.inp; "
       "param=FILE, ini=FILE or test=FILE for other names; may be repeated",
       true},
      {"threads", "N", "for the mpm driver; or A-B: the program chooses while it runs; default: 1 to all"},
      {"reference", "FILE.csv", "show a curve with columns named as in element.csv beside the others"},
      {"force", "", "overwrite the results in the folder"}};
  options.insert(options.end(), own.begin(), own.end());
  return options;
}

} // namespace

Command element_command() {
  return {.name = "element",
          .usage = "TEST [CASE.toml] [options]",
          .summary = "Element tests: oedometer, triaxial, shear, biaxial, or a user-defined path.",
          .max_words = 2,
          .options = element_options(),
          .run = element,
          .more_help = element_help,
          .first_words = element_tests()};
}

} // namespace riedel
