#include "apps/reproduce/band_theory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace riedel {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// u/h0, φ, θ, and the three thicknesses; until 1.3 % of strain the rate is that of the whole layer.
constexpr std::array<BandState, 28> band_1d_rows{{
    {0.00019998, 3.2393, 54.993, 0, 0.0803, 0.00399},         {0.00219758, 25.3, 54.915, 0, 0.08029, 0.00399},
    {0.00399201, 37.271, 54.828, 0, 0.08032, 0.003991},       {0.00598204, 46.162, 54.717, 0, 0.08038, 0.003994},
    {0.00816647, 52.505, 54.58, 0, 0.08048, 0.004},           {0.00915781, 54.525, 54.512, 0, 0.08053, 0.004003},
    {0.0101482, 56.11, 54.442, 0, 0.0806, 0.004006},          {0.0111375, 57.315, 54.368, 0, 0.08066, 0.00401},
    {0.0113353, 57.513, 54.353, 0, 0.08068, 0.004011},        {0.0119283, 58.03, 54.307, 0, 0.08072, 0.004014},
    {0.0123234, 58.312, 54.276, 0, 0.08075, 0.004016},        {0.0129159, 58.643, 54.23, 0, 0.0808, 0.00402},
    {0.0135079, 58.872, 54.185, 0, 0.02864, 0.00503},         {0.0139025, 58.97, 54.157, 0, 0.0176, 0.005035},
    {0.0144939, 58.968, 54.139, 0, 0.0106, 0.006059},         {0.0150851, 56.957, 54.144, 0, 0.007635, 0.007128},
    {0.015479, 53.71, 54.154, 0, 0.006675, 0.007185},         {0.0160695, 49.928, 54.165, 0, 0.006737, 0.00725},
    {0.0170529, 46.411, 54.175, 0, 0.006806, 0.006289},       {0.0180354, 44.273, 54.182, 0, 0.00686, 0.006339},
    {0.0201933, 41.254, 54.19, 0, 0.005902, 0.006428},        {0.0223465, 39.266, 54.196, 0.001648, 0.00597, 0.006498},
    {0.0248851, 37.587, 54.2, 0.003874, 0.006036, 0.006568},  {0.0299426, 35.371, 54.206, 0.005051, 0.006138, 0.006675},
    {0.0351668, 33.916, 54.21, 0.006216, 0.006216, 0.005668}, {0.0401709, 32.956, 54.213, 0.006273, 0.00517, 0.005722},
    {0.044958, 32.285, 54.214, 0.006316, 0.005208, 0.005762}, {0.0499114, 31.764, 54.216, 0.00635, 0.005239, 0.005795},
}};

} // namespace

double plane_strain_critical_angle(double critical_angle_deg) {
  const double s = std::sin(critical_angle_deg * degree);
  const double c1 = std::sqrt(3.0 / 8.0) * (3.0 - s) / s, c2 = 3.0 / 8.0 * (3.0 + s) / s;
  const double x = (std::sqrt(c1 * c1 + 4.0 * c2) - c1) / (2.0 * c2); // x (c1 + c2 x) = 1, cos 3θ = 0
  return std::asin(3.0 * x / std::numbers::sqrt2) / degree;
}

double traction_ratio(double angle_deg, double theta_deg) {
  const double s = std::sin(angle_deg * degree), ratio = (1.0 + s) / (1.0 - s), t = std::tan(theta_deg * degree);
  return (ratio - 1.0) * t / (ratio + t * t);
}

double outer_angle(double traction, double theta_deg) {
  const double t = std::tan(theta_deg * degree), ratio = t * (1.0 + traction * t) / (t - traction);
  return std::asin((ratio - 1.0) / (ratio + 1.0)) / degree;
}

double residual_angle(double critical_angle_deg, double theta_deg) {
  return outer_angle(std::sin(plane_strain_critical_angle(critical_angle_deg) * degree), theta_deg);
}

BandAngles band_angles(double friction_deg, double dilatancy_deg) {
  return {.roscoe = 45.0 + 0.5 * dilatancy_deg,
          .arthur = 45.0 + 0.25 * (friction_deg + dilatancy_deg),
          .coulomb = 45.0 + 0.5 * friction_deg};
}

BandState band_1d(double u_over_h) {
  const auto above = std::ranges::lower_bound(band_1d_rows, u_over_h, {}, &BandState::u_over_h);
  if (above == band_1d_rows.begin()) return band_1d_rows.front();
  if (above == band_1d_rows.end()) return band_1d_rows.back();
  const BandState &a = *std::prev(above), &b = *above;
  const double t = (u_over_h - a.u_over_h) / (b.u_over_h - a.u_over_h);
  return {u_over_h,
          std::lerp(a.angle, b.angle, t),
          std::lerp(a.inclination_deg, b.inclination_deg, t),
          std::lerp(a.thickness_e, b.thickness_e, t),
          std::lerp(a.thickness_rate, b.thickness_rate, t),
          std::lerp(a.thickness_fwhm, b.thickness_fwhm, t)};
}

double band_1d_angle(double u_over_h, double theta_deg) {
  const BandState band = band_1d(u_over_h);
  return outer_angle(traction_ratio(band.angle, band.inclination_deg), theta_deg);
}

} // namespace riedel
