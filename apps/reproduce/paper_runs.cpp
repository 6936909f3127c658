#include "apps/reproduce/paper_runs.hpp"

#include "core/base/parameters.hpp"

#include <algorithm>

namespace riedel {

namespace {

using Settings = std::vector<Setting>;

std::string length_name(double length) { return "l_c=" + short_text(1e3 * length) + "mm"; }

/// Adds a run unless it is there already.
void add(std::vector<Variant>& runs, const CaseFile& given, const std::string& name, const std::string& label,
         const Settings& settings) {
  if (std::ranges::find(runs, name, &Variant::name) != runs.end()) return;
  Variant run{.given = given, .name = name, .label = label, .settings = settings};
  for (const auto& [key, value] : settings) run.given.override_with(key + "=" + value, "riedel reproduce:");
  runs.push_back(std::move(run));
}

void add_meshes(std::vector<Variant>& runs, const CaseFile& given) {
  const std::vector<std::string> cells{"[16,56]", "[24,84]", "[32,112]"};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string name = mesh_runs()[i];
    const Settings mesh{{"grid.cells", cells[i]}};
    add(runs, given, name, name, mesh);
    add(runs, given, with_fixed_step(name), name + ", Δt = 1e-6 s",
        {mesh.front(), {"time.step", exact_text(fixed_step)}});
  }
}

} // namespace

std::vector<std::string> mesh_runs() { return {"16x56", paper_run, "32x112"}; }
std::string with_fixed_step(const std::string& mesh_run) { return mesh_run + ",dt=1e-6"; }

const std::vector<double>& lengths() {
  static const std::vector<double> all{0.0, 1.5e-3, 1.75e-3, 2e-3, 2.5e-3, 3e-3, 4e-3};
  return all;
}

std::vector<std::string> length_runs() {
  std::vector<std::string> names;
  for (const double length : lengths()) names.push_back(length == 1.5e-3 ? paper_run : length_name(length));
  return names;
}

std::vector<std::string> density_runs() { return {paper_run, "e0=0.75", "e0=0.90"}; }

const std::vector<Way>& all_ways() {
  static const std::vector<Way> ways{{.name = "paper",
                                      .title = "as the paper did it",
                                      .scheme = "gimp",
                                      .suffix = "",
                                      .settings = {"time.stress_filter=0", "time.flip=0.98"}},
                                     {.name = "filtered",
                                      .title = "filtered, at 0.025 m/s",
                                      .scheme = "cpdi",
                                      .suffix = ",filtered",
                                      .settings = {"loading.speed=0.025"}}};
  return ways;
}

std::vector<Variant> paper_runs(const CaseFile& given, const Figures& figures, const Way& way) {
  std::vector<Variant> runs;
  if (figures.contains(7) || figures.contains(8) || figures.contains(9) || figures.contains(10))
    add(runs, given, paper_run, paper_run, {{"grid.cells", "[24,84]"}, {"output.frames_every_strain", "0.002"}});
  if (figures.contains(7)) add_meshes(runs, given);
  if (figures.contains(8))
    for (const double length : lengths())
      if (length != 1.5e-3)
        add(runs, given, length_name(length), "l_c = " + short_text(1e3 * length) + " mm",
            {{"nonlocal.length", exact_text(length)}});
  if (figures.contains(10))
    for (const char* void_ratio : {"0.75", "0.90"})
      add(runs, given, std::string("e0=") + void_ratio, std::string("e₀ = ") + void_ratio,
          {{"specimen.void_ratio", void_ratio}});
  for (Variant& run : runs) {
    run.name += way.suffix;
    run.label += way.suffix;
  }
  return runs;
}

} // namespace riedel
