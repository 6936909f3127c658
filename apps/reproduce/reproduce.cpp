/// riedel reproduce: the paper, figure by figure, and its statements compared with the results.
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/kinds.hpp"
#include "apps/reproduce/figures.hpp"
#include "apps/reproduce/statements.hpp"
#include "core/base/error.hpp"
#include "core/campaign/record.hpp"
#include "core/campaign/report.hpp"
#include "core/campaign/results_table.hpp"
#include "core/campaign/run_campaign.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/marked_document.hpp"
#include "core/io/progress.hpp"
#include "core/run/failure.hpp"
#include "core/run/interrupt.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iostream>

namespace riedel {

namespace {

namespace fs = std::filesystem;

Figures wanted_figures(const Arguments& arguments) {
  std::vector<std::string> known;
  for (const int figure : all_figures) known.push_back(std::to_string(figure));
  Figures figures;
  for (const std::string& name : arguments.names("figure", known, known)) figures.insert(std::stoi(name));
  return figures;
}

std::vector<Way> wanted_ways(const Arguments& arguments) {
  std::vector<std::string> known;
  for (const Way& way : all_ways()) known.push_back(way.name);
  std::vector<Way> ways;
  for (const std::string& name : arguments.names("way", known, known))
    ways.push_back(*std::ranges::find(all_ways(), name, &Way::name));
  return ways;
}

CaseFile paper_case(const Arguments& arguments, const Way& way) {
  CaseFile given = CaseFile::empty();
  std::vector<std::string> settings{"scheme=" + way.scheme, "output.plots=false", "output.frames_every_strain=0.01"};
  settings.insert(settings.end(), way.settings.begin(), way.settings.end());
  for (const std::string& setting : settings) given.override_with(setting, "riedel reproduce:");
  return arguments.with_settings(std::move(given));
}

struct Reproduction {
  std::vector<FigurePart> curves;
  std::vector<SpecimenFigure> specimens;
  std::vector<Verdicts> verdicts;
};

Reproduction reproduction_of(const std::vector<PaperResults>& ways, const Figures& figures, Runs elements) {
  Reproduction found{.curves = element_figures(figures, elements), .specimens = {}, .verdicts = {}};
  std::vector<Statement> of_elements;
  if (const CriticalState end = triaxial_end(elements, ways.front().paper_case().section("material"));
      !end.angle.empty())
    of_elements = element_statements(end);
  const auto move_to = [](auto& all, auto&& some) {
    for (auto& one : some) all.push_back(std::move(one));
  };
  for (const PaperResults& results : ways) {
    found.verdicts.push_back({results.way().title, of_elements});
    move_to(found.verdicts.back().statements, biaxial_statements(results));
    move_to(found.curves, curve_figures(results));
    move_to(found.specimens, specimen_figures(results));
  }
  move_to(found.curves, experiment_figures(ways));
  std::ranges::stable_sort(found.curves, {}, &FigurePart::figure); // those of every way together
  return found;
}

Page report(const std::string& command, const std::vector<PaperResults>& ways, const Reproduction& found) {
  Page page("Krzyżanowski, Wójcik and Tejchman (2020), reproduced");
  page.facts(provenance(command, ways.front().all()));
  page.heading("Statements of the paper, and results");
  page.table(statement_table(found.verdicts));
  for (std::size_t i = 0; i < found.curves.size(); ++i) {
    const FigurePart& part = found.curves[i];
    const bool first = i == 0 || found.curves[i - 1].figure != part.figure;
    const bool last = i + 1 == found.curves.size() || found.curves[i + 1].figure != part.figure;
    if (first) page.heading("Figure " + std::to_string(part.figure));
    page.plot(part.plot, part.caption);
    for (const SpecimenFigure& specimens : found.specimens)
      if (last && specimens.figure == part.figure)
        for (const DrawnField& field : pictured_fields)
          page.pictures(field_pictures(specimens.runs, field, drawn_strain));
  }
  for (const PaperResults& results : ways) {
    if (results.all().empty()) continue;
    page.heading("The runs " + results.way().title);
    for (const auto& [heading, table] : run_kind("biaxial").tables(results.all())) page.table(table);
    page.table(settings_table(results.all()));
  }
  return page;
}

/// Runs of one kind, done now or earlier; none if no figure needs any.
struct PaperRuns {
  OutputFolder folder; ///< locked until the figures are drawn
  std::vector<RunResult> results;
};
PaperRuns runs_of(const RunKind& kind, const Arguments& arguments, const std::vector<Variant>& variants,
                  const fs::path& folder, const Interrupt& interrupt) {
  if (variants.empty()) return {.folder = OutputFolder(folder, arguments.command, true), .results = {}};
  const Plan plan = plan_of(kind, "The paper", arguments.command, variants,
                            [](const CaseFile& given) { return load_catalogue(given).catalogue; });
  OpenCampaign campaign = open_campaign(folder, plan, arguments.force(), run_kinds());
  run_campaign(plan, folder, {"reproduce", arguments.threads().maximum, [&] { return static_cast<bool>(interrupt); }});
  const std::vector<RunResult> results = results_of(campaign.plan, folder);
  write_atomically(folder / "results.csv", results_csv(results));
  return {.folder = std::move(campaign.folder), .results = results};
}

int reproduce(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Figures figures = wanted_figures(arguments);
  const Catalogue catalogue = load_catalogue().catalogue;
  const std::vector<std::string> scheme = arguments.names("scheme", {}, catalogue.in_2d.schemes.names());
  std::vector<Variant> variants;
  std::vector<Way> ways = wanted_ways(arguments);
  std::vector<Values> cases;
  for (Way& way : ways) {
    if (!scheme.empty()) way.scheme = scheme.front();
    const CaseFile given = paper_case(arguments, way);
    cases.push_back(run_kind("biaxial").cases.check(given, catalogue).values);
    for (Variant& run : paper_runs(given, figures, way)) variants.push_back(std::move(run));
  }
  std::optional<MarkedDocument> document;
  if (const auto path = arguments.text("document")) document.emplace(*path, "riedel reproduce");
  const fs::path folder = arguments.out(fs::path("results/reproduce") / ways.front().scheme);
  const Interrupt interrupt;

  const PaperRuns runs = runs_of(run_kind("biaxial"), arguments, variants, folder, interrupt);
  if (interrupt) return interrupt.exit_code();
  std::optional<PaperRuns> elements;
  if (const std::vector<Variant> tests = element_runs(figures); !tests.empty())
    elements.emplace(runs_of(run_kind("element"), arguments, tests, folder / "elements", interrupt));
  if (interrupt) return interrupt.exit_code();
  std::vector<PaperResults> results;
  for (std::size_t i = 0; i < ways.size(); ++i) results.emplace_back(runs.results, figures, cases[i], ways[i]);
  const Reproduction found = reproduction_of(results, figures, elements ? Runs(elements->results) : Runs{});
  write_atomically(folder / "verdicts.md", statement_markdown(found.verdicts));
  std::vector<std::string> written{"verdicts.md"};
  try_to_write("the report", [&] {
    write_atomically(folder / "report.html", report(arguments.command, results, found).html());
    written.emplace_back("report.html");
  });
  try_to_write("the pictures", [&] {
    for (std::string& name : write_figures(found.curves, found.specimens, folder)) written.push_back(std::move(name));
  });
  if (document) document->write(statement_markdown(found.verdicts));

  std::cout << statement_text(found.verdicts) << "written to " << folder.string();
  for (const std::string& name : written) std::cout << (&name == &written.front() ? ": " : ", ") << name;
  std::cout << "\ntook "
            << duration_text(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()) << "\n";
  return 0;
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
                     full_catalogue().in_2d.schemes.names()});
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

} // namespace

Command reproduce_command() {
  return {.name = "reproduce",
          .usage = "[options]",
          .summary = "Reproduces the paper figure by figure, and compares its statements with the results.",
          .max_words = 0,
          .options = reproduce_options(),
          .run = reproduce,
          .more_help = reproduce_help};
}

} // namespace riedel
