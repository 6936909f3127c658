#include "apps/element/curve.hpp"

#include "core/io/figure_json.hpp"

#include <Eigen/Eigenvalues>

namespace riedel {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// asin((a − b)/(a + b)), 0 where there is no compression [deg]
double angle_between(double a, double b) {
  return a + b > 0.0 ? std::asin(std::clamp((a - b) / (a + b), -1.0, 1.0)) * degrees : 0.0;
}

std::string reason_of(const ElementCurve& curve) {
  if (!curve.failure.empty()) return curve.failure;
  std::string reason;
  for (const std::string& end : curve.ends) reason += (reason.empty() ? "" : "; ") + end;
  if (curve.interrupted.empty()) return reason;
  return reason + (reason.empty() ? "" : "; ") + "interrupted in " + curve.interrupted;
}

} // namespace

double principal_angle(const Sym<double>& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(to_matrix(stress), Eigen::EigenvaluesOnly);
  return angle_between(-solver.eigenvalues()[0], -solver.eigenvalues()[2]);
}

ElementRow element_row(const LawPoint& point, double void_ratio, Friction friction, double pore_pressure) {
  ElementRow row;
  for (int a = 0; a < 3; ++a) {
    row.eps[static_cast<std::size_t>(a)] = 1.0 - point.F(a, a);
    row.sigma[static_cast<std::size_t>(a)] = -point.stress.m[static_cast<std::size_t>(a)];
  }
  row.gamma = point.F(0, 1);
  row.tau = point.stress.m[3] / std::numbers::sqrt2 + 0.0; // no minus zero
  row.void_ratio = void_ratio;
  row.phi_principal = principal_angle(point.stress);
  row.phi_mob = row.phi_principal;
  if (friction == Friction::in_plane) row.phi_mob = angle_between(row.sigma[0], row.sigma[1]);
  if (friction == Friction::on_planes) row.phi_mob = std::atan2(row.tau, row.sigma[1]) * degrees;
  for (double& sigma : row.sigma) sigma += pore_pressure;
  row.pore_pressure = pore_pressure;
  row.time = point.time;
  return row;
}

std::vector<std::string> element_columns(const std::string& test, bool water) {
  std::vector<std::string> names{"eps_1",      "eps_2",      "eps_3",  "gamma",      "sigma_1_Pa",
                                 "sigma_2_Pa", "sigma_3_Pa", "tau_Pa", "void_ratio", "phi_mob_deg"};
  if (test == "shear") names.emplace_back("phi_principal_deg");
  names.insert(names.end(), {"time_s", "stage", "cycle", "p_Pa", "q_Pa"});
  if (water) names.emplace_back("pore_pressure_Pa");
  return names;
}

std::vector<double> element_numbers(const ElementRow& r, const std::string& test, bool water) {
  std::vector<double> numbers{r.eps[0],   r.eps[1],   r.eps[2], r.gamma,      r.sigma[0],
                              r.sigma[1], r.sigma[2], r.tau,    r.void_ratio, r.phi_mob};
  if (test == "shear") numbers.push_back(r.phi_principal);
  const auto stage = static_cast<double>(r.stage), cycle = static_cast<double>(r.cycle);
  numbers.insert(numbers.end(), {r.time, stage, cycle, r.p(), r.q()});
  if (water) numbers.push_back(r.pore_pressure);
  return numbers;
}

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
    const auto& [kinetic, internal, external, ratio, spread] = *curve.energies;
    summary["kinetic_J"] = kinetic;
    summary["internal_J"] = internal;
    summary["external_J"] = external;
    summary["kinetic_over_internal_max"] = figure_json(ratio);
    summary["stress_spread_max"] = figure_json(spread);
  }
  return summary;
}

} // namespace riedel
