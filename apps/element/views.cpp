#include "apps/element/views.hpp"

#include "apps/element/pictures.hpp"
#include "apps/element/tests/tests.hpp"
#include "core/base/error.hpp"
#include "core/io/figure_json.hpp"

#include <algorithm>

namespace riedel {

namespace {

using nlohmann::ordered_json;

/// A figure of a summary in its unit; a dash where there is none.
std::string figure(const ordered_json& summary, const char* name, double unit, int digits) {
  const double x = figure_in(summary, name);
  return std::isnan(x) ? "–" : fixed_text(x / unit, digits);
}

/// The strain against which a test is reported.
const char* strain_of(const ordered_json& summary) { return shears(text_in(summary, "test", "")) ? "gamma" : "eps_1"; }

/// The curve of a run for the pictures, as it was written.
ElementCurve curve_of(const RunResult& run) {
  const Table& table = run.history;
  ElementCurve curve{.test = text_in(run.summary, "test", ""), .water = table.has("pore_pressure_Pa")};
  for (std::size_t i = 0; i < table["eps_1"].size(); ++i) {
    const auto at = [&](const char* column) { return table[column][i]; };
    ElementRow row{.eps = {at("eps_1"), at("eps_2"), at("eps_3")},
                   .gamma = at("gamma"),
                   .sigma = {at("sigma_1_Pa"), at("sigma_2_Pa"), at("sigma_3_Pa")},
                   .tau = at("tau_Pa"),
                   .void_ratio = at("void_ratio"),
                   .phi_mob = at("phi_mob_deg"),
                   .time = at("time_s")};
    if (curve.water) row.pore_pressure = at("pore_pressure_Pa");
    curve.rows.push_back(row);
  }
  return curve;
}

} // namespace

std::vector<NamedPlot> element_run_plots(Runs runs, const std::string& subject) {
  std::vector<NamedCurve> curves;
  for (const RunResult& run : runs)
    if (run.history.has("eps_1")) curves.push_back({run.label, curve_of(run)});
  const auto differs = [&](const NamedCurve& one) { return one.curve.test != curves.front().curve.test; };
  if (curves.empty() || std::ranges::any_of(curves, differs)) return {};
  return element_plots(curves, std::nullopt, subject);
}

PageTable element_table(Runs runs) {
  PageTable table{.caption = "Strength, and the state at the end of each test.",
                  .header = {"run", "test", "driver", "φ peak [°]", "at strain [%]", "φ at the end [°]", "e at the end",
                             "strain at the end [%]", "σ₁ at the end [kPa]", "wall time [s]"},
                  .rows = {}};
  for (const RunResult& run : runs) {
    const std::string strain = strain_of(run.summary);
    table.rows.push_back({{{run.label},
                           {text_in(run.summary, "test", "–")},
                           {text_in(run.summary, "driver", "–")},
                           {figure(run.summary, "phi_peak_deg", 1.0, 2)},
                           {figure(run.summary, (strain + "_at_peak").c_str(), 0.01, 2)},
                           {figure(run.summary, "phi_final_deg", 1.0, 2)},
                           {figure(run.summary, "void_ratio_final", 1.0, 4)},
                           {figure(run.summary, (strain + "_final").c_str(), 0.01, 2)},
                           {figure(run.summary, "sigma_1_final_Pa", 1e3, 1)},
                           {figure(run.summary, "wall_s", 1.0, 2)}},
                          run.name});
  }
  return table;
}

std::string element_outcome(const ordered_json& s) {
  const std::string strain = strain_of(s);
  return "peak " + figure(s, "phi_peak_deg", 1.0, 2) + " deg at " + figure(s, (strain + "_at_peak").c_str(), 0.01, 2) +
         " %, end " + figure(s, "phi_final_deg", 1.0, 2) + " deg, e = " + figure(s, "void_ratio_final", 1.0, 4) + ", " +
         figure(s, "wall_s", 1.0, 2) + " s";
}

void check_element_summary(const ordered_json& summary) {
  for (const char* name : {"phi_peak_deg", "phi_final_deg", "void_ratio_final", "wall_s"})
    if (const ordered_json& value = summary.at(name); !value.is_number() && !value.is_null())
      throw InputError(std::string(name) + " is no number");
}

} // namespace riedel
