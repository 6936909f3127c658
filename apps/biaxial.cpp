/// riedel biaxial: the plane strain compression test, from a case to numbers, files for ParaView and pictures.
#include "apps/band_report.hpp"
#include "apps/biaxial_keys.hpp"
#include "apps/biaxial_pictures.hpp"
#include "apps/catalogue.hpp"
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/messages.hpp"
#include "apps/output_folder.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/case_text.hpp"
#include "core/io/progress.hpp"

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <omp.h>

namespace riedel {

namespace {

constexpr double quasi_static_limit = 0.05; ///< greatest kinetic over internal energy of a quasi-static run

/// The warning that a fixed time step deserves, once.
class TimeStepWatch {
public:
  void look(const Simulation<2>& simulation) {
    if (told_ || simulation.time_step() <= simulation.crossing_time()) return;
    told_ = true;
    print_warning("time.step = " + exact_text(simulation.time_step()) + " s is over the stable limit, " +
                  exact_text(simulation.crossing_time()) + " s at step " + std::to_string(simulation.state().step) +
                  ": the run may blow up");
  }

private:
  bool told_ = false;
};

void write_summary(const std::filesystem::path& folder, nlohmann::ordered_json summary) {
  write_atomically(folder / "summary.json", summary.dump(2) + "\n");
}

nlohmann::ordered_json summary_of(const BiaxialRun& run, const Values& values, const std::string& status, double wall,
                                  int threads) {
  const nlohmann::ordered_json known = run.summary();
  const double point_steps = known["points"].get<double>() * std::max(1.0, known["steps"].get<double>());
  nlohmann::ordered_json all{{"case", "biaxial"}, {"version", version()}, {"status", status}};
  all.update(known);
  all["wall_s"] = wall;
  all["ns_per_point_step"] = 1e9 * wall / point_steps;
  all["threads"] = threads;
  all["quasi_static"] = run.kinetic_over_internal() <= quasi_static_limit;
  all["band"] = band_json(measure_band(run.frame(), values));
  return all;
}

void print_result(const nlohmann::ordered_json& s, const std::filesystem::path& folder,
                  const std::vector<std::string>& pictures) {
  const auto& band = s["band"];
  std::printf("peak       %.2f deg at u/h0 = %.2f %%\nresidual   %.2f deg (mean of the last 1 %% of u/h0)\n",
              s["phi_peak_deg"].get<double>(), 100 * s["u_over_h_at_peak"].get<double>(),
              s["phi_residual_deg"].get<double>());
  if (band["found"].get<bool>())
    std::printf("shear band %s, inclined %.1f deg, thickness %.2f mm (half maximum), %.2f mm (by void ratio)\n",
                band["kind"].get<std::string>().c_str(), band["inclination_deg"].get<double>(),
                1e3 * band["thickness_fwhm_m"].get<double>(), 1e3 * band["thickness_m"].get<double>());
  else
    std::printf("shear band none\n");
  std::printf("energy     kinetic over internal at most %.2g\ntime       %.1f s, %.0f ns per point and step\n",
              s["kinetic_over_internal_max"].get<double>(), s["wall_s"].get<double>(),
              s["ns_per_point_step"].get<double>());
  std::printf("written to %s: case.toml, history.csv, summary.json", folder.c_str());
  for (const std::string& name : pictures) std::printf(", %s", name.c_str());
  std::printf("\n");
}

} // namespace

int biaxial(const Arguments& arguments) {
  const Catalogue catalogue = full_catalogue();
  const BiaxialCase given = biaxial_case(arguments.case_file(), catalogue);
  for (const std::string& warning : given.warnings) print_warning(warning);
  const std::filesystem::path folder = arguments.out("results/biaxial");
  prepare_output_folder(folder, arguments.force());
  omp_set_num_threads(arguments.threads());
  const Values& values = given.values;
  write_atomically(folder / "case.toml", case_text(given.keys, values));

  BiaxialRun run(values, catalogue, folder);
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  const auto summary = [&](const std::string& status) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return summary_of(run, values, status, wall.count(), arguments.threads());
  };
  try {
    Progress progress("biaxial");
    TimeStepWatch watch;
    watch.look(run.simulation());
    run.advance([&] { return static_cast<bool>(interrupt); },
                [&](const BiaxialRow& row) {
                  watch.look(run.simulation());
                  std::array<char, 48> note{};
                  std::snprintf(note.data(), note.size(), "u/h0 = %.2f %%, phi = %.1f deg", 100 * row.u_over_h,
                                row.angle);
                  progress.update(row.u_over_h / values.number("loading.final_strain"), note.data());
                });
  } catch (const RunError& error) {
    write_summary(folder, {{"case", "biaxial"},
                           {"version", version()},
                           {"status", "failed"},
                           {"reason", error.what()},
                           {"steps", run.simulation().state().step}});
    throw;
  }
  run.finish();
  const nlohmann::ordered_json result = summary(interrupt ? "interrupted" : "done");
  write_summary(folder, result);
  std::vector<std::string> pictures;
  if (values.flag("output.plots")) pictures = draw_biaxial(run, values, folder);
  print_result(result, folder, pictures);
  if (!result["quasi_static"].get<bool>())
    print_warning("the run is not quasi-static: kinetic energy reached " + exact_text(run.kinetic_over_internal()) +
                  " of the internal one; use a smaller loading.speed");
  return interrupt ? interrupt.exit_code() : 0;
}

} // namespace riedel
