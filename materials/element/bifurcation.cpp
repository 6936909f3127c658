#include "materials/element/bifurcation.hpp"

#include "materials/gudehus_bauer.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>

namespace riedel {

namespace {

constexpr double increment =
    1e-5; ///< of the logarithmic vertical strain; Heun's error is far below the digits reported
constexpr int steps_between_looks = 10;
constexpr double first_angle = 40.0, last_angle = 75.0, angle_step = 0.25; ///< of the bands tested [deg]

struct State {
  Sym<double> stress;
  double void_ratio;
};

/// x is horizontal, y vertical.
Sym<double> plane_rate(double d_xx, double d_yy) { return {{d_xx, d_yy, 0.0, 0.0, 0.0, 0.0}}; }

class Compression {
public:
  Compression(const GudehusBauer& law, double void_ratio, double pressure)
      : law_(law), state_{-pressure * Sym<double>::identity(), void_ratio}, pressure_(pressure) {}

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] Rate<double, 1> rate(const State& at, const Sym<double>& D) const {
    return law_.rate(at.stress, {at.void_ratio}, D, norm(D));
  }
  /// From this call on, the specimen is extended and unloads.
  void turn_back() {
    d_yy_ = 1.0;
    d_xx_ = -0.3;
  }
  /// The rate of deformation that keeps σ_xx constant, with D_yy = −1, or 1 during unloading.
  [[nodiscard]] Sym<double> direction(const State& at) const {
    double a = d_xx_, b = a + 1e-3, f_a = rate(at, plane_rate(a, d_yy_)).stress.m[0];
    for (int i = 0; i < 50 && std::abs(b - a) > 1e-13; ++i) { // secant method
      const double f_b = rate(at, plane_rate(b, d_yy_)).stress.m[0];
      if (f_b == f_a) break;
      const double next = b - f_b * (b - a) / (f_b - f_a);
      a = b, f_a = f_b, b = next;
    }
    return plane_rate(b, d_yy_);
  }
  /// Heun's step.
  void step() {
    const Sym<double> D1 = direction(state_);
    d_xx_ = D1.m[0];
    const Rate<double, 1> r1 = rate(state_, D1);
    const State trial = moved(r1);
    const Rate<double, 1> r2 = rate(trial, direction(trial));
    state_ = moved({.stress = 0.5 * (r1.stress + r2.stress), .state = {0.5 * (r1.state[0] + r2.state[0])}});
  }
  [[nodiscard]] double angle() const {
    const double sigma_1 = -state_.stress.m[1];
    return std::asin((sigma_1 - pressure_) / (sigma_1 + pressure_)) * 180.0 / std::numbers::pi;
  }

private:
  [[nodiscard]] State moved(const Rate<double, 1>& by) const {
    return {state_.stress + increment * by.stress, state_.void_ratio + increment * by.state[0]};
  }

  const GudehusBauer& law_;
  State state_;
  double pressure_, d_xx_ = 0.3, d_yy_ = -1.0;
};

using Plane = Mat<2>;

Plane plane_of(const Sym<double>& a) {
  Plane m;
  m << a.m[0], a.m[3] / std::numbers::sqrt2, a.m[3] / std::numbers::sqrt2, a.m[1];
  return m;
}

/// Criteria for a band with the normal n: each reaches 1 when the band becomes possible.
struct Closeness {
  double linear, nonlinear;
};

/// A jump g⊗n of the velocity gradient changes the traction rate by [L:D + Wσ − σW]·n + (d1 − d0) N·n, which must
/// vanish: g = (d1 − d0) r. With R the symmetric part of r⊗n, a finite jump exists once ‖R‖ ≥ 1; an infinitesimal one,
/// as in the linear solid, once R:D ≥ ‖D‖.
Closeness closeness(const Compression& test, const Sym<double>& D, const Vec<2>& n) {
  const Plane stress = plane_of(test.state().stress);
  const auto odd_part = [&](const Sym<double>& of) { // L:D
    return plane_of(0.5 * (test.rate(test.state(), of).stress - test.rate(test.state(), -1.0 * of).stress));
  };
  const Sym<double> unit = D / norm(D);
  const Plane N = plane_of(0.5 * (test.rate(test.state(), unit).stress + test.rate(test.state(), -1.0 * unit).stress));
  Plane acoustic;
  for (int a = 0; a < 2; ++a) {
    const Vec<2> g = Vec<2>::Unit(a);
    const Plane velocity_gradient = g * n.transpose();
    const Plane sym = 0.5 * (velocity_gradient + velocity_gradient.transpose());
    const Plane spin = 0.5 * (velocity_gradient - velocity_gradient.transpose());
    const Sym<double> jump{{sym(0, 0), sym(1, 1), 0.0, std::numbers::sqrt2 * sym(0, 1), 0.0, 0.0}};
    acoustic.col(a) = (odd_part(jump) + spin * stress - stress * spin) * n;
  }
  const Vec<2> r = -acoustic.inverse() * (N * n);
  const Plane R = 0.5 * (r * n.transpose() + n * r.transpose());
  return {.linear = (R.array() * plane_of(unit).array()).sum(), .nonlinear = R.norm()};
}

/// Checks whether a criterion has reached 1 at any inclination since the last call.
class Watch {
public:
  explicit Watch(double Closeness::*criterion) : criterion_(criterion) {}

  void record(const Compression& test, const Sym<double>& D, double u_over_h, Onset& onset) {
    if (onset.u_over_h > 0.0) return;
    double best = -1.0, at = 0.0;
    for (double angle = first_angle; angle <= last_angle; angle += angle_step) {
      const double theta = angle * std::numbers::pi / 180.0;
      const double value = closeness(test, D, {-std::sin(theta), std::cos(theta)}).*criterion_;
      if (value > best) best = value, at = angle;
    }
    if (best >= 1.0 && before_ < 1.0 && before_ > 0.0)
      onset = {std::lerp(strain_before_, u_over_h, (1.0 - before_) / (best - before_)), at};
    before_ = best;
    strain_before_ = u_over_h;
  }

private:
  double Closeness::*criterion_;
  double before_ = -1.0, strain_before_ = 0.0;
};

} // namespace

HomogeneousTest homogeneous_test(const Values& parameters, double void_ratio, double pressure, double end) {
  const GudehusBauer law(parameters);
  Compression compression(law, void_ratio, pressure);
  HomogeneousTest test;
  Watch linear(&Closeness::linear), nonlinear(&Closeness::nonlinear);
  for (int step = 0;; ++step) {
    const double u_over_h = 1.0 - std::exp(-increment * step);
    if (u_over_h > end) break;
    if (step % steps_between_looks == 0) {
      test.u_over_h.push_back(u_over_h);
      test.angle.push_back(compression.angle());
      test.void_ratio.push_back(compression.state().void_ratio);
      if (step > 0) {
        const Sym<double> D = compression.direction(compression.state());
        linear.record(compression, D, u_over_h, test.linear);
        nonlinear.record(compression, D, u_over_h, test.nonlinear);
      }
    }
    if (compression.angle() > test.peak_angle) {
      test.peak_angle = compression.angle();
      test.peak_u_over_h = u_over_h;
    }
    compression.step();
  }
  return test;
}

Unloading unloading_after(const Values& parameters, double void_ratio, double pressure, double from) {
  const GudehusBauer law(parameters);
  Compression compression(law, void_ratio, pressure);
  double strain = 0.0; // logarithmic
  for (; 1.0 - std::exp(-strain) < from; strain += increment) compression.step();
  compression.turn_back();
  Unloading path;
  for (int step = 0; compression.angle() > 0.0; ++step, strain -= increment, compression.step())
    if (step % steps_between_looks == 0) {
      path.u_over_h.push_back(1.0 - std::exp(-strain));
      path.angle.push_back(compression.angle());
    }
  return path;
}

} // namespace riedel
