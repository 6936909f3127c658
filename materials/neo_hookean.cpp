#include "materials/neo_hookean.hpp"

namespace riedel {

Keys NeoHookean::parameters() { return ElasticSolid::keys(); }

NeoHookean::NeoHookean(const Values& given) : solid_(given) { check_bounds(parameters(), given, name); }

double NeoHookean::density(std::span<const double> state) const {
  return solid_.density * std::exp(-state[volume_strain]);
}

Sym<double> NeoHookean::stress(const Sym<double>& b) const {
  const double J = std::sqrt(determinant(b)), ln_J = std::log(J);
  return (solid_.mu / J) * (b - Sym<double>::identity()) + (solid_.lambda * ln_J / J) * Sym<double>::identity(); // (2)
}

/// (2) solved for b is b = I + (J σ − λ ln J I)/μ; the remaining condition is det b = J². Newton's method in x = ln J,
/// with steps limited so that b stays positive.
Sym<double> NeoHookean::stretch_under(const Sym<double>& sigma) const {
  constexpr int max_steps = 100;
  const Spectral principal = spectral(sigma);
  const Vec<3> one = Vec<3>::Ones();
  const auto stretch = [&](double x) -> Vec<3> {
    return one + (std::exp(x) * principal.values - solid_.lambda * x * one) / solid_.mu; // (5)
  };
  double x = 0.0; // or, if b would not be positive, a stronger compression
  while (!(stretch(x).minCoeff() > 0.0) && x > -10.0) x -= 0.5;
  for (int step = 0; step < max_steps; ++step) {
    const Vec<3> b = stretch(x);
    const Vec<3> slope = (std::exp(x) * principal.values - solid_.lambda * one) / solid_.mu;
    const double f = b.array().log().sum() - 2.0 * x, df = (slope.array() / b.array()).sum() - 2.0; // (6)
    if (!(df < 0.0)) break; // beyond the largest stress that the material can carry
    double change = -f / df;
    if (std::abs(change) <= 1e-14) return from_spectral(b, principal.directions);
    while (!(stretch(x + change).minCoeff() > 0.0) && std::abs(change) > 1e-14) change *= 0.5;
    x += change;
  }
  return std::numeric_limits<double>::quiet_NaN() * Sym<double>::identity();
}

Sym<double> NeoHookean::stretch_of(const Point& point) const {
  Sym<double> b;
  std::copy_n(point.state.begin(), 6, b.m.begin());
  return dot(b, b) == 0.0 ? stretch_under(point.stress) : b;
}

void NeoHookean::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  for (Index p = 0; p < batch.size; ++p) {
    const BatchGroup<double, variables> place(batch, p);
    const Sym<double> strain = batch.time_step * place.rate();
    if (dot(strain, strain) == 0.0) continue;
    Point point = place.points();
    const Sym<double> stretch = isotropic_function(spectral(strain), [](double e) { return std::exp(e); });
    const Sym<double> b = congruent(stretch, stretch_of(point)); // (4)
    point.stress = stress(b);
    if (!std::isfinite(dot(point.stress, point.stress))) {
      report.fail(p, "the stress is not a finite number, or no stretch gives the initial stress");
      continue;
    }
    std::copy_n(b.m.begin(), 6, point.state.begin());
    point.state[volume_strain] += trace(strain);
    place.put(point);
  }
}

MaterialLimits NeoHookean::assess(const MaterialBatch& batch) const {
  double fastest = 0.0; // c²
  for (Index p = 0; p < batch.size; ++p) {
    const Point point = BatchGroup<double, variables>(batch, p).points();
    const Sym<double> b = stretch_of(point);
    const double J = std::sqrt(determinant(b)), density = solid_.density * std::exp(-point.state[volume_strain]);
    const double along = std::max(0.0, solid_.lambda + solid_.mu - solid_.lambda * std::log(J));
    const double c_squared = (along + solid_.mu * principal_values(b)[0]) / (J * density); // (7)
    if (c_squared > fastest) fastest = c_squared;                                          // skips NaN
  }
  return {.wave_speed = std::sqrt(fastest)};
}

} // namespace riedel
