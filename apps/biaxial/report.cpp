#include "apps/biaxial/report.hpp"

#include "apps/biaxial/band.hpp"
#include "apps/command_line.hpp"
#include "core/io/figure_json.hpp"

#include <cstdio>

namespace riedel {

namespace {

using nlohmann::ordered_json;

/// With its unit; a dash where there is none.
std::string figure(const ordered_json& json, const char* name, double unit, int digits, const std::string& of = "") {
  const double x = figure_in(json, name);
  if (std::isnan(x)) return "-";
  return fixed_text(unit * x, digits) + of;
}

std::string ending_line(const ordered_json& s) {
  const double share = figure_in(s, "u_over_h") / figure_in(s, "final_strain");
  return s.at("status").get<std::string>() + " at u/h0 = " + figure(s, "u_over_h", 100.0, 3, " %") + ", " +
         short_text(100.0 * share) + " % of the case\n";
}

std::string strength_lines(const ordered_json& s) {
  const bool rising = figure_in(s, "u_over_h_at_peak") >= figure_in(s, "u_over_h");
  const double residual = figure_in(s, "phi_residual_deg");
  return "peak       " + figure(s, "phi_peak_deg", 1.0, 2, " deg") +
         " at u/h0 = " + figure(s, "u_over_h_at_peak", 100.0, 2, " %") +
         (rising ? ", still rising where the run ends" : "") + "\nresidual   " +
         figure(s, "phi_residual_deg", 1.0, 2, " deg") +
         (std::isnan(residual) ? " (only for a run to its final strain, at least 1 % of u/h0 after the peak)\n"
                               : " (mean of the last 1 % of u/h0)\n");
}

std::string band_line(const ordered_json& band) {
  const std::string kind = text_in(band, "kind", "-");
  if (kind == "none" || kind == "-") return "shear band " + kind + "\n";
  const bool by_shear = text_in(band, "measured_by", "") == "shear_strain";
  return "shear band " + kind + ", inclined " + figure(band, "inclination_deg", 1.0, 1, " deg") + ", thickness " +
         figure(band, "thickness_fwhm_m", 1e3, 2, " mm") + " (half maximum" +
         (by_shear ? " of the shear strain), " : "), ") + figure(band, "thickness_m", 1e3, 2, " mm") +
         " (by void ratio)\n";
}

std::string quality_line(const ordered_json& quality) {
  if (std::isnan(figure_in(quality, "pressure_scatter"))) return "";
  return "stresses   p of neighbours in the band differs by " + figure(quality, "pressure_scatter", 100.0, 1, " %") +
         ", " + figure(quality, "stressless_in_band", 1.0, 0) + " of " + figure(quality, "core_points", 1.0, 0) +
         " points without stress\n";
}

} // namespace

template <int Dim>
ordered_json biaxial_summary(const BiaxialRun<Dim>& run, const BiaxialCase& values, const BiaxialEnding& ending) {
  const ordered_json known = run.summary();
  const double point_steps = known["points"].get<double>() * known["steps"].get<double>();
  const double kinetic = run.kinetic_over_internal();
  ordered_json all{{"case", "biaxial"}, {"version", version()}, {"status", ending.status}};
  if (!ending.reason.empty()) all["reason"] = ending.reason;
  all.update(known);
  all["wall_s"] = ending.wall;
  all["ns_per_point_step"] = figure_json(1e9 * ending.wall / point_steps);
  all["threads"] = ending.threads;
  all["time_step_over_limit_max"] = figure_json(ending.step_over_limit);
  all["quasi_static"] = nullptr;
  if (ending.step_over_limit > 1.0 || !std::isnan(kinetic))
    all["quasi_static"] = ending.step_over_limit <= 1.0 && kinetic <= quasi_static_limit;
  if (ending.status == "failed") {
    all["band"] = band_json(ShearBand{});
    for (auto& figure : all["band"]) figure = nullptr;
    all["stress"] = quality_json({});
  } else {
    const Frame section = run.section();
    const ShearBand band = measure_band(section, values);
    all["band"] = band_json(band);
    all["stress"] = quality_json(measure_quality(section, band, values));
  }
  all["stress"].update(run.quality());
  return all;
}

std::string biaxial_text(const ordered_json& s) {
  const ordered_json band = s.contains("band") ? s.at("band") : ordered_json();
  std::string text = s.at("status") == "done" ? "" : ending_line(s);
  text += strength_lines(s) + band_line(band);
  if (s.contains("stress")) text += quality_line(s.at("stress"));
  const double kinetic = figure_in(s, "kinetic_over_internal_max");
  text += "energy     kinetic over internal " +
          (std::isnan(kinetic) ? "- (from u/h0 = 0.5 % on)\n" : "at most " + short_text(kinetic, 2) + "\n");
  if (!std::isnan(figure_in(s, "transfer_over_external")))
    text += "           " + figure(s, "transfer_over_external", 100.0, 2, " %") +
            " of the external work lost between points and nodes, " +
            figure(s, "unaccounted_over_external", 100.0, 3, " %") + " not accounted for\n";
  return text + "time       " + figure(s, "wall_s", 1.0, 1, " s") + ", " +
         figure(s, "ns_per_point_step", 1.0, 0, " ns per point and step") + "\n";
}

template ordered_json biaxial_summary(const BiaxialRun<2>&, const BiaxialCase&, const BiaxialEnding&);
template ordered_json biaxial_summary(const BiaxialRun<3>&, const BiaxialCase&, const BiaxialEnding&);

} // namespace riedel
