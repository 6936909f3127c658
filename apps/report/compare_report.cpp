#include "apps/report/compare_report.hpp"

#include "apps/bench_machine.hpp"
#include "apps/command_line.hpp"

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

} // namespace

std::vector<std::pair<std::string, std::string>> provenance(const std::string& command, Runs runs) {
  return {{"Version", version()},
          {"Command", command},
          {"Machine", processor_name() + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors, " +
                          instruction_set()},
          {"Runs", count_text(runs)}};
}

Page compare_report(const std::string& title, const std::string& command, Runs runs) {
  Page page(title);
  page.facts(provenance(command, runs));
  page.plot(curves_of(runs, ""),
            "Mobilised friction angle over vertical strain. A click on a run picks it out, here, among the "
            "pictures and in the tables; another click, or Escape, lets it go.");
  page.heading("Shear band");
  page.table(band_table(runs));
  const double strain = common_strain(runs);
  for (const auto& [field, label] :
       {std::pair{"void_ratio", "void ratio e [-]"}, {"shear_strain", "shear strain γ [-]"}}) {
    const PagePictures pictures = field_pictures(runs, field, label, strain);
    if (!pictures.pictures.empty()) page.pictures(pictures);
  }
  page.heading("Energies and cost");
  page.table(cost_table(runs));
  page.heading("Settings");
  page.table(settings_table(runs));
  return page;
}

} // namespace riedel
