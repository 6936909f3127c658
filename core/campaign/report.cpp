#include "core/campaign/report.hpp"

#include "core/base/error.hpp"
#include "core/base/machine.hpp"
#include "core/campaign/legend.hpp"
#include "core/draw/picture.hpp"
#include "core/io/version.hpp"

#include <algorithm>
#include <thread>

namespace riedel {

namespace {

std::string count_text(Runs runs) {
  const auto done = std::ranges::count(runs, RunStatus::done, &RunResult::status);
  std::string text = std::to_string(done) + " of " + std::to_string(runs.size()) + " done";
  for (const RunStatus status : {RunStatus::failed, RunStatus::refused, RunStatus::missing, RunStatus::damaged})
    if (const auto count = std::ranges::count(runs, status, &RunResult::status); count > 0)
      text += ", " + std::to_string(count) + " " + name_of(status);
  return text;
}

std::vector<RunResult> with_legend(Runs runs) {
  std::vector<RunResult> called(runs.begin(), runs.end());
  for (RunResult& run : called)
    if (!run.settings.empty()) run.label = run.legend;
  return called;
}

/// With the colour and the dashes of the settings in which each run differs.
Plot campaign_curves(const RunKind& kind, Runs runs, const std::string& title) {
  std::vector<std::vector<Setting>> settings;
  for (const RunResult& run : runs) settings.push_back(run.settings);
  const std::vector<Pen> pens = pens_of(settings, kind.schemes);
  const auto begun = std::ranges::find_if(runs, [](const RunResult& run) { return !run.axes.x.empty(); });
  Plot plot = begun == runs.end() ? Plot{} : curves_of(runs, title, begun->axes);
  for (Series& series : plot.series) {
    const auto run = std::ranges::find(runs, series.id, &RunResult::name);
    const Pen& pen = pens[static_cast<std::size_t>(run - runs.begin())];
    series.color = pen.color;
    series.dashes = pen.dashes;
  }
  return plot;
}

/// The settings of a run except its scheme.
std::vector<Setting> but_for_scheme(const RunResult& run) {
  std::vector<Setting> rest = run.settings;
  std::erase_if(rest, [](const Setting& setting) { return setting.first == "scheme"; });
  return rest;
}

/// Sorts runs that differ only in their scheme next to each other, otherwise keeps their order.
std::vector<const RunResult*> by_scheme(Runs runs) {
  std::vector<const RunResult*> sorted;
  for (const RunResult& run : runs) {
    const auto alike = [&](const RunResult* other) { return but_for_scheme(*other) == but_for_scheme(run); };
    const auto last = std::ranges::find_if(sorted.rbegin(), sorted.rend(), alike);
    sorted.insert(last == sorted.rend() ? sorted.end() : last.base(), &run);
  }
  return sorted;
}

/// At most nine, and whole rows of schemes.
std::size_t panels_of_a_picture(Runs runs) {
  constexpr std::size_t maximum = 9;
  const std::vector<Setting> first = runs.empty() ? std::vector<Setting>{} : but_for_scheme(runs.front());
  const auto alike = static_cast<std::size_t>(
      std::ranges::count_if(runs, [&](const RunResult& run) { return but_for_scheme(run) == first; }));
  return alike == 0 || alike > maximum ? maximum : maximum / alike * alike;
}

/// The first setting in which a run differs goes above the rest.
Panel panel_of(const Frame& frame, const std::string& label) {
  const std::size_t comma = label.find(", ");
  return {&frame, label.substr(0, comma), comma == std::string::npos ? "" : label.substr(comma + 2)};
}

} // namespace

std::vector<std::pair<std::string, std::string>> provenance(const std::string& command, Runs runs) {
  std::vector<std::pair<std::string, std::string>> facts{
      {"Version", version()},
      {"Command", command},
      {"Machine", processor_name() + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors, " +
                      instruction_set()}};
  if (!runs.empty()) facts.emplace_back("Runs", count_text(runs));
  return facts;
}

Page campaign_report(const Plan& plan, Runs results) {
  const std::vector<RunResult> runs = with_legend(results);
  Page page(plan.title);
  page.facts(provenance(plan.command, runs));
  const Plot curves = campaign_curves(*plan.kind, runs, "");
  if (curves.series.empty())
    page.paragraph("No run has produced a curve.");
  else
    page.plot(curves, plan.kind->curves_caption + " Click a run to highlight it here, in the pictures and in the "
                                                  "tables; click again or press Escape to undo this.");
  const double strain = plan.kind->has_frames ? common_strain(runs) : 0.0;
  bool first = true;
  for (const auto& [heading, table] : plan.kind->tables(runs)) {
    page.heading(heading);
    page.table(table);
    if (std::exchange(first, false) && plan.kind->has_frames)
      for (const DrawnField& field : drawn_fields)
        if (const PagePictures pictures = field_pictures(runs, field, strain); !pictures.pictures.empty())
          page.pictures(pictures);
  }
  page.heading("Settings");
  page.table(settings_table(runs));
  return page;
}

std::vector<std::string> write_campaign_pictures(const Plan& plan, Runs results, const std::filesystem::path& folder) {
  const std::vector<RunResult> runs = with_legend(results);
  std::vector<std::string> names{"curves.png"};
  const Plot curves = campaign_curves(*plan.kind, runs, plan.title);
  if (curves.series.empty()) return {};
  write_png(folder / names.front(), curves);
  if (plan.kind->plots != nullptr)
    for (const auto& [file, plot] : plan.kind->plots(runs, "")) {
      write_png(folder / file, plot);
      names.push_back(file);
    }
  if (!plan.kind->has_frames) return names;
  const double strain = common_strain(runs);
  const std::size_t maximum = panels_of_a_picture(runs);
  for (const DrawnField& field : pictured_fields) {
    const auto [frames, labels] = frames_with(field, by_scheme(runs), strain);
    for (std::size_t first = 0; first < frames.size(); first += maximum) {
      std::vector<Panel> panels;
      for (std::size_t i = first; i < std::min(first + maximum, frames.size()); ++i)
        panels.push_back(panel_of(frames[i], labels[i]));
      names.push_back(std::string(field.name) + "_" + std::to_string(1 + first / maximum) + ".png");
      write_field_pictures(folder / names.back(), panels,
                           {.field = field.name,
                            .component = field.component,
                            .unit = field.unit,
                            .title = "",
                            .subtitle = "",
                            .label = field_label(field, strain, 1),
                            .range = field_range(frames, field),
                            .width = 2400,
                            .height = 900});
    }
  }
  return names;
}

} // namespace riedel
