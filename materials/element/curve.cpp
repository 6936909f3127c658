#include "materials/element/curve.hpp"

#include <Eigen/Eigenvalues>

namespace riedel {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// asin((a − b)/(a + b)), 0 if there is no compression [deg]
double angle_between(double a, double b) {
  return a + b > 0.0 ? std::asin(std::clamp((a - b) / (a + b), -1.0, 1.0)) * degrees : 0.0;
}

} // namespace

double principal_angle(const Sym<double>& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(to_matrix(stress), Eigen::EigenvaluesOnly);
  return angle_between(-solver.eigenvalues()[0], -solver.eigenvalues()[2]);
}

ElementRow element_row(const MaterialPoint& point, double void_ratio, Friction friction, double pore_pressure) {
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

std::vector<std::string> element_columns(bool sheared, bool water) {
  std::vector<std::string> names{"eps_1",      "eps_2",      "eps_3",  "gamma",      "sigma_1_Pa",
                                 "sigma_2_Pa", "sigma_3_Pa", "tau_Pa", "void_ratio", "phi_mob_deg"};
  if (sheared) names.emplace_back("phi_principal_deg");
  names.insert(names.end(), {"time_s", "stage", "cycle", "p_Pa", "q_Pa"});
  if (water) names.emplace_back("pore_pressure_Pa");
  return names;
}

std::vector<double> element_numbers(const ElementRow& r, bool sheared, bool water) {
  std::vector<double> numbers{r.eps[0],   r.eps[1],   r.eps[2], r.gamma,      r.sigma[0],
                              r.sigma[1], r.sigma[2], r.tau,    r.void_ratio, r.phi_mob};
  if (sheared) numbers.push_back(r.phi_principal);
  const auto stage = static_cast<double>(r.stage), cycle = static_cast<double>(r.cycle);
  numbers.insert(numbers.end(), {r.time, stage, cycle, r.p(), r.q()});
  if (water) numbers.push_back(r.pore_pressure);
  return numbers;
}

} // namespace riedel
