#include "apps/element/summary.hpp"

#include "core/io/figure_json.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::string reason_of(const ElementCurve& curve) {
  if (!curve.failure.empty()) return curve.failure;
  std::string reason;
  for (const std::string& end : curve.ends) reason += (reason.empty() ? "" : "; ") + end;
  if (curve.interrupted.empty()) return reason;
  return reason + (reason.empty() ? "" : "; ") + "interrupted in " + curve.interrupted;
}

} // namespace

nlohmann::ordered_json element_summary(const ElementCurve& curve) {
  const auto peak = std::ranges::max_element(curve.rows, {}, &ElementRow::phi_mob);
  const ElementRow& last = curve.rows.back();
  nlohmann::ordered_json summary{{"status", !curve.failure.empty()       ? "failed"
                                            : !curve.interrupted.empty() ? "interrupted"
                                                                         : "done"},
                                 {"reason", reason_of(curve)},
                                 {"steps", curve.steps},
                                 {"rows", curve.rows.size()},
                                 {"phi_peak_deg", peak->phi_mob},
                                 {"eps_1_at_peak", peak->eps[0]},
                                 {"gamma_at_peak", peak->gamma},
                                 {"phi_final_deg", last.phi_mob},
                                 {"void_ratio_final", last.void_ratio},
                                 {"eps_1_final", last.eps[0]},
                                 {"gamma_final", last.gamma},
                                 {"sigma_1_final_Pa", last.sigma[0]},
                                 {"time_final_s", last.time},
                                 {"evaluated_twice", curve.report.evaluated_twice},
                                 {"substepped", curve.report.substepped},
                                 {"substeps", curve.report.substeps},
                                 {"rejected_substeps", curve.report.rejected_substeps},
                                 {"low_pressure", curve.report.low_pressure},
                                 {"separated", curve.report.separated}};
  if (curve.water) summary["pore_pressure_final_Pa"] = last.pore_pressure;
  if (curve.energies) {
    const ElementEnergies& energies = *curve.energies;
    summary["kinetic_J"] = energies.kinetic;
    summary["internal_J"] = energies.internal;
    summary["external_J"] = energies.external;
    summary["kinetic_over_internal_max"] = figure_json(energies.kinetic_over_internal);
    summary["stress_spread_max"] = figure_json(energies.stress_spread);
    summary["time_step_over_limit_max"] = figure_json(energies.time_step_over_limit);
  }
  return summary;
}

} // namespace riedel
