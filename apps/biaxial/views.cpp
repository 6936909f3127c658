#include "apps/biaxial/views.hpp"

#include "core/base/error.hpp"
#include "core/io/figure_json.hpp"

namespace riedel {

namespace {

using nlohmann::ordered_json;

const PageCell none{"–", "faint"};

/// A figure of a summary, or of the band in it, in its unit; a dash where there is none.
PageCell figure(const ordered_json& json, const char* name, double unit, int digits) {
  const double x = figure_in(json, name);
  return std::isnan(x) ? none : PageCell{fixed_text(x / unit, digits)};
}

/// An object; empty where no band was found.
ordered_json band_of(const RunResult& run) {
  if (!run.summary.is_object() || !run.summary.contains("band")) return ordered_json::object();
  const ordered_json& band = run.summary.at("band");
  return text_in(band, "kind", "none") != "none" ? band : ordered_json::object();
}

/// The part of the summary on stresses; empty where a run has none.
ordered_json quality_of(const RunResult& run) {
  const bool has = run.summary.is_object() && run.summary.contains("stress");
  return has ? run.summary.at("stress") : ordered_json::object();
}

PageCell exponent(const ordered_json& json, const char* name) {
  const double x = figure_in(json, name);
  if (std::isnan(x)) return none;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", x);
  return {text.data()};
}

PageCell last_of(const RunResult& run, const char* column, int digits) {
  if (!run.history.has(column)) return none;
  return {fixed_text(run.history[column].back(), digits)};
}

PageCell kind_of_band(const RunResult& run) {
  if (run.status != RunStatus::done) return {name_of(run.status), "faint"};
  const ordered_json& band = run.summary.at("band");
  return {text_in(band, "kind", "none") + (text_in(band, "doubt", "").empty() ? "" : ", doubtful")};
}

std::string text_of(const ordered_json& json, const char* name, double unit, int digits) {
  const double x = figure_in(json, name);
  if (std::isnan(x)) return "-";
  return fixed_text(unit * x, digits);
}

} // namespace

PageTable band_table(Runs runs) {
  PageTable table{
      .caption = "Strength, and the shear band at the end of each run. t_s: thickness, by the void ratio as in "
                 "the paper, and as the full width at half maximum of the increase of e and of the rate ‖D‖. "
                 "Scatter: of the pressure about its local mean in the band, not visible in the curves; above 10 % "
                 "the stresses there are unreliable.",
      .header = {"run", "φ peak [°]", "at u/h₀ [%]", "φ residual [°]", "band", "θ [°]", "t_s by e [mm]",
                 "t_s by e / l_c", "t_s half max. of e [mm]", "t_s half max. of ‖D‖ [mm]", "e inside",
                 "scatter of p [%]", "without stress"},
      .rows = {}};
  for (const RunResult& run : runs) {
    const ordered_json band = band_of(run), quality = quality_of(run);
    table.rows.push_back({{{run.label},
                           figure(run.summary, "phi_peak_deg", 1.0, 2),
                           figure(run.summary, "u_over_h_at_peak", 0.01, 2),
                           figure(run.summary, "phi_residual_deg", 1.0, 1),
                           kind_of_band(run),
                           figure(band, "inclination_deg", 1.0, 1),
                           figure(band, "thickness_m", 1e-3, 2),
                           figure(band, "thickness_over_lc", 1.0, 1),
                           figure(band, "thickness_fwhm_m", 1e-3, 2),
                           figure(band, "thickness_rate_m", 1e-3, 2),
                           figure(band, "void_ratio_inside", 1.0, 3),
                           figure(quality, "pressure_scatter", 0.01, 1),
                           figure(quality, "stressless_in_band", 1.0, 0)},
                          run.name});
  }
  return table;
}

PageTable cost_table(Runs runs) {
  PageTable table{
      .caption = "Energies at the end, per metre of depth, and what the run took. Kinetic over internal energy: "
                 "the maximum after u/h₀ = 0.5 %. Lost: energy that the nodes did not return to the points; "
                 "open: energy not accounted for.",
      .header = {"run", "internal [J/m]", "external [J/m]", "kinetic/internal", "lost/external [%]",
                 "open/external [%]", "mass error", "points", "steps", "wall time [s]", "ns per point and step"},
      .rows = {}};
  for (const RunResult& run : runs)
    table.rows.push_back({{{run.label},
                           last_of(run, "internal_J_per_m", 2),
                           last_of(run, "external_J_per_m", 2),
                           exponent(run.summary, "kinetic_over_internal_max"),
                           figure(run.summary, "transfer_over_external", 0.01, 2),
                           figure(run.summary, "unaccounted_over_external", 0.01, 3),
                           exponent(run.summary, "mass_error"),
                           figure(run.summary, "points", 1.0, 0),
                           figure(run.summary, "steps", 1.0, 0),
                           figure(run.summary, "wall_s", 1.0, 1),
                           figure(run.summary, "ns_per_point_step", 1.0, 0)},
                          run.name});
  return table;
}

std::string biaxial_outcome(const ordered_json& s) {
  const ordered_json& band = s.at("band");
  std::string text = "peak " + text_of(s, "phi_peak_deg", 1.0, 2) + " deg at " +
                     text_of(s, "u_over_h_at_peak", 100.0, 2) + " %, residual " +
                     text_of(s, "phi_residual_deg", 1.0, 2) + " deg, ";
  const std::string kind = text_in(band, "kind", "none");
  text += kind != "none"
              ? (kind == "diffuse" ? "diffuse zone at " : "band at ") + text_of(band, "inclination_deg", 1.0, 1) +
                    " deg, " + text_of(band, "thickness_fwhm_m", 1e3, 2) + " mm"
              : "no band";
  return text + ", " + text_of(s, "wall_s", 1.0, 1) + " s";
}

void check_biaxial_summary(const ordered_json& summary) {
  for (const char* figure : {"phi_peak_deg", "u_over_h_at_peak", "phi_residual_deg", "wall_s"})
    if (const ordered_json& value = summary.at(figure); !value.is_number() && !value.is_null())
      throw InputError(std::string(figure) + " is no number");
  const ordered_json& band = summary.at("band");
  if (!band.at("found").is_boolean()) throw InputError("band.found is neither true nor false");
  if (!band.at("kind").is_string()) throw InputError("band.kind is no text");
}

} // namespace riedel
