/// riedel reproduce: the paper, figure by figure, and its statements beside what comes out.
#include "apps/biaxial_keys.hpp"
#include "apps/campaign/carry_out.hpp"
#include "apps/campaign/record.hpp"
#include "apps/campaign/results_table.hpp"
#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/failure.hpp"
#include "apps/interrupt.hpp"
#include "apps/marked_document.hpp"
#include "apps/report/compare_report.hpp"
#include "apps/reproduce/figures.hpp"
#include "apps/reproduce/statements.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/progress.hpp"

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

CaseFile paper_case(const Arguments& arguments, const std::string& scheme) {
  CaseFile given = CaseFile::empty();
  for (const std::string& setting :
       {"scheme=" + scheme, std::string("output.plots=false"), std::string("output.frames_every_strain=0.01")})
    given.override_with(setting, "riedel reproduce:");
  return arguments.with_settings(std::move(given));
}

struct Reproduction {
  std::vector<FigurePart> curves;
  std::vector<SpecimenFigure> specimens;
  std::vector<Statement> statements;
};

Reproduction reproduction_of(const PaperResults& results, const Catalogue& catalogue) {
  Reproduction found{.curves = element_figures(results.figures(), catalogue), .specimens = {}, .statements = {}};
  if (!found.curves.empty()) found.statements = element_statements(triaxial_end(catalogue));
  for (FigurePart& part : curve_figures(results)) found.curves.push_back(std::move(part));
  found.specimens = specimen_figures(results);
  for (Statement& statement : biaxial_statements(results)) found.statements.push_back(std::move(statement));
  return found;
}

Page report(const std::string& command, const PaperResults& results, const Reproduction& found) {
  Page page("Krzyżanowski, Wójcik and Tejchman (2020), reproduced");
  page.facts(provenance(command, results.all()));
  page.heading("What the paper says, and what came out");
  page.table(statement_table(found.statements));
  int figure = 0;
  for (const FigurePart& part : found.curves) {
    if (part.figure != figure) page.heading("Figure " + std::to_string(figure = part.figure));
    page.plot(part.plot, part.caption);
    for (const SpecimenFigure& specimens : found.specimens)
      if (specimens.figure == part.figure)
        page.pictures(field_pictures(specimens.runs, drawn_fields.front(), drawn_strain));
  }
  if (results.all().empty()) return page;
  page.heading("The runs");
  page.table(band_table(results.all()));
  page.table(cost_table(results.all()));
  page.table(settings_table(results.all()));
  return page;
}

/// The runs of Figures 7 to 10, done now or before; none where no figure needs any.
struct PaperRuns {
  OutputFolder folder; ///< held until the figures are drawn
  std::vector<RunResult> results;
};
PaperRuns runs_of(const Arguments& arguments, const CaseFile& given, const Figures& figures, const fs::path& folder,
                  const Interrupt& interrupt) {
  const std::vector<Variant> variants = paper_runs(given, figures);
  if (variants.empty()) return {.folder = OutputFolder(folder, arguments.command, true), .results = {}};
  const Plan plan = plan_of("The paper", arguments.command, variants);
  OpenCampaign campaign = open_campaign(folder, plan, arguments.force());
  carry_out(plan, folder, {"reproduce", arguments.threads().most, [&] { return static_cast<bool>(interrupt); }});
  const std::vector<RunResult> results = results_of(campaign.plan, folder);
  write_atomically(folder / "results.csv", results_csv(results));
  return {.folder = std::move(campaign.folder), .results = results};
}

void print(const std::vector<Statement>& statements) {
  for (const Statement& s : statements)
    std::cout << name_of(s.verdict) << std::string(13 - std::string(name_of(s.verdict)).size(), ' ') << s.where << ": "
              << s.claim << "\n             " << s.measured
              << (s.theory.empty() ? "" : "\n             theory: " + s.theory)
              << (s.reason.empty() ? "" : "\n             " + s.reason) << "\n";
}

} // namespace

int reproduce(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Figures figures = wanted_figures(arguments);
  const Catalogue catalogue = inventory().catalogue;
  const std::string scheme = arguments.names("scheme", {"gimp"}, catalogue.in_2d.schemes.names()).front();
  const CaseFile given = paper_case(arguments, scheme);
  const Values values = biaxial_case(given, catalogue).values;
  std::optional<MarkedDocument> document;
  if (const auto path = arguments.text("document")) document.emplace(*path, "riedel reproduce");
  const fs::path folder = arguments.out(fs::path("results/reproduce") / scheme);
  const Interrupt interrupt;

  const PaperRuns runs = runs_of(arguments, given, figures, folder, interrupt);
  const PaperResults results(runs.results, figures, values);
  if (interrupt) return interrupt.exit_code();
  const Reproduction found = reproduction_of(results, catalogue);
  write_atomically(folder / "verdicts.md", statement_markdown(found.statements));
  std::vector<std::string> written{"verdicts.md"};
  try_to_write("the report", [&] {
    write_atomically(folder / "report.html", report(arguments.command, results, found).html());
    written.emplace_back("report.html");
  });
  try_to_write("the pictures", [&] {
    for (std::string& name : write_figures(found.curves, found.specimens, folder)) written.push_back(std::move(name));
  });
  if (document) document->write(statement_markdown(found.statements));

  print(found.statements);
  std::cout << "written to " << folder.string();
  for (const std::string& name : written) std::cout << (&name == &written.front() ? ": " : ", ") << name;
  std::cout << "\ntook "
            << duration_text(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()) << "\n";
  return 0;
}

} // namespace riedel
