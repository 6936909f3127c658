/// Drained plane strain compression of dense Karlsruhe sand at 50 kPa, up to u/h0 = 5 %: the strain path of
/// tests/reference/integrator_errors.csv, solved in fine steps by another method than those under test.
#pragma once

#include "materials/gudehus_bauer.hpp"
#include "materials/kit/runge_kutta.hpp"

namespace riedel::test {

using SandPoint = PointState<double, 1>;

struct PathPlace {
  double lateral = 0.0; ///< strain across
  SandPoint point{.stress = -5e4 * Sym<double>::identity(), .state = {0.55}};
};

/// D of a unit axial compression under which the lateral stress does not change.
inline Sym<double> drained_rate(const GudehusBauer& law, const SandPoint& at) {
  const auto lateral = [&](const Sym<double>& D, double d) {
    return law.rate<double>(at.stress, at.state, D, d).stress.m[0];
  };
  const Sym<double> zero = Sym<double>::zero();
  const double a = lateral({{1, 0, 0, 0, 0, 0}}, 0.0), b = lateral({{0, -1, 0, 0, 0, 0}}, 0.0), c = lateral(zero, 1.0);
  double x = 0.5; // of a x + b + c √(1 + x²) = 0
  for (int i = 0; i < 30; ++i) {
    const double d = std::hypot(1.0, x);
    x -= (a * x + b + c * d) / (a + c * x / d);
  }
  return {{x, -1, 0, 0, 0, 0}};
}

/// States after every 1e-6 of axial strain, by the classical method of order 4.
inline std::vector<PathPlace> plane_strain_path(const GudehusBauer& law, int steps) {
  constexpr double h = 1e-6;
  struct Slope {
    double lateral;
    Rate<double, 1> rate;
  };
  const auto slope_at = [&](const SandPoint& at) {
    const Sym<double> D = drained_rate(law, at);
    return Slope{D.m[0], law.rate<double>(at.stress, at.state, D, norm(D))};
  };
  std::vector<PathPlace> path(1);
  for (int i = 0; i < steps; ++i) {
    const PathPlace& p = path.back();
    const Slope k1 = slope_at(p.point), k2 = slope_at(moved(p.point, k1.rate, 0.5 * h)),
                k3 = slope_at(moved(p.point, k2.rate, 0.5 * h)), k4 = slope_at(moved(p.point, k3.rate, h));
    SandPoint end = moved(moved(p.point, k1.rate, h / 6.0), k2.rate, h / 3.0);
    end = moved(moved(end, k3.rate, h / 3.0), k4.rate, h / 6.0);
    path.push_back({p.lateral + h / 6.0 * (k1.lateral + 2 * k2.lateral + 2 * k3.lateral + k4.lateral), end});
  }
  return path;
}

} // namespace riedel::test
