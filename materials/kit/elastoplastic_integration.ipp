/// The bodies of ElastoplasticLaw's member functions; part of elastoplastic_law.hpp, after the class.

namespace riedel {

/// By regula falsi with the Illinois rule on h(x) = f(x) − x, h(0) ≥ 0.
template <class F>
double fixed_point(const F& f, double first, double round_off) {
  constexpr int max_steps = 100;
  double low = 0.0, h_low = first, high = first, h_high = f(high) - high;
  int step = 0;
  for (; h_high > 0.0 && step < max_steps; ++step) {
    low = high, h_low = h_high;
    high *= 2.0;
    h_high = f(high) - high;
  }
  for (; step < max_steps; ++step) {
    const double x = std::clamp((low * h_high - high * h_low) / (h_high - h_low), low, high), h = f(x) - x;
    if (std::abs(h) <= std::max(1e-14 * high, round_off)) return x;
    if (h > 0.0) {
      low = x, h_low = h;
      h_high *= 0.5;
    } else {
      high = x, h_high = h;
      h_low *= 0.5;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

template <class Real>
Real ElastoplasticControl::max_squared_speed(const Sym<Real>& sigma, const Real& volume_strain, double added) const {
  const Real J = exp(volume_strain);
  if (!hencky) return Real((solid.longitudinal() + added) / solid.density) * J;
  // In principal axes the shear stiffness is μ x coth x ≤ μ (1 + x²/3), x the difference of two elastic strains, and
  // the stress itself adds to the stiffness in any direction.
  const Sym<Real> tau = J * sigma, s = deviator(tau);
  const Real x_squared = Real(0.5 / (solid.mu * solid.mu)) * dot(s, s);
  return (Real(solid.longitudinal() + added) + Real(2.0 / 3.0 * solid.mu) * x_squared + norm(tau)) /
         Real(solid.density);
}

/// Advances the points that certainly stay elastic, and those at rest. @return which these are
template <class Law>
Mask ElastoplasticLaw<Law>::stay_elastic(const BatchGroup<Pack, variables>& group) const {
  constexpr double doubt = 1e-6; // principal values of a pack are accurate to 1e-8
  const Point<Pack> start = group.points();
  const Sym<Pack> strain = Pack(group.time_step()) * group.rate();
  const Mask still = dot(strain, strain) <= Pack(0.0);
  if (control_.hencky) return still;
  Point<Pack> trial = start;
  trial.stress = start.stress + solid().stress(strain);
  trial.state[volume_strain] += trace(strain);
  Pack averaged(0.0);
  if (group.averaged()) averaged = group.load(group.averaged());
  const auto strength =
      law().strength(softening_strain(start.state[plastic_strain], group.averaged() ? &averaged : nullptr));
  const Mask inside = law().yield(principal_values(trial.stress), strength) < Pack(-doubt) * norm(trial.stress);
  group.put(select(inside, trial, start));
  return inside || still;
}

template <class Law>
void ElastoplasticLaw<Law>::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  for (Index p = 0; p < batch.size; p += pack_size) {
    const BatchGroup<Pack, variables> group(batch, p);
    const auto done = lanes(stay_elastic(group));
    for (int k = 0; k < group.size(); ++k) {
      if (done[k]) continue;
      const BatchGroup<double, variables> place(batch, p + k);
      Point<double> point = place.points();
      const double* averaged = batch.averaged ? batch.averaged + p + k : nullptr;
      const std::string_view why = advance(point, batch.time_step * place.rate(), averaged);
      if (why.empty())
        place.put(point);
      else
        report.fail(p + k, why);
    }
  }
}

/// Advances one point by one step. @return why that failed, or empty
template <class Law>
std::string_view ElastoplasticLaw<Law>::advance(Point<double>& point, const Sym<double>& strain,
                                                const double* averaged) const {
  const Sym<double> trial = control_.trial(point.stress, point.state[volume_strain], strain);
  if (!std::isfinite(dot(trial, trial))) return "the elastic trial stress is not a finite number";
  point.state[volume_strain] += trace(strain);
  const Spectral principal = spectral(trial);
  const auto strength = law().strength(softening_strain(point.state[plastic_strain], averaged));
  if (law().yield(std::array{principal.values[0], principal.values[1], principal.values[2]}, strength) > 0.0)
    return flow(point, principal, averaged);
  point.stress = trial;
  return {};
}

/// Plastic flow from a trial stress outside the yield surface: the return to the surface for κ + Δκ yields Δκ itself.
template <class Law>
std::string_view ElastoplasticLaw<Law>::flow(Point<double>& point, const Spectral& trial,
                                             const double* averaged) const {
  const double kappa = point.state[plastic_strain], J = control_.hencky ? std::exp(point.state[volume_strain]) : 1.0;
  const auto stress = [&](double increment) {
    return law().returned(trial.values, law().strength(softening_strain(kappa + increment, averaged)));
  };
  const auto plastic = [&](const Vec<3>& sigma) { // Δε_p = C⁻¹ J (σ_trial − σ), and κ̇ = √(2/3) ‖dev D_p‖
    const Vec<3> lost = trial.values - sigma;
    return J / (std::sqrt(6.0) * solid().mu) * (lost - lost.mean() * Vec<3>::Ones()).norm();
  };
  double increment = plastic(stress(0.0));
  const bool own_matters = law().softens() && !(averaged && control_.nonlocal_factor == 1.0);
  if (own_matters && increment > 0.0)
    increment = fixed_point([&](double x) { return plastic(stress(x)); }, increment,
                            1e-15 * J / solid().mu * trial.values.norm());
  if (!std::isfinite(increment)) return "the softening over the step has no solution";
  point.stress = from_spectral(stress(own_matters ? increment : 0.0), trial.directions);
  point.state[plastic_strain] += increment;
  return {};
}

template <class Law>
MaterialLimits ElastoplasticLaw<Law>::assess(const MaterialBatch& batch) const {
  constexpr double softened = 1e300;
  const double added = std::max(control_.added_by(law().directions(law().strength(0.0))),
                                control_.added_by(law().directions(law().strength(softened))));
  Pack fastest(0.0); // c²
  for (Index p = 0; p < batch.size; p += pack_size) {
    const Point<Pack> q = BatchGroup<Pack, variables>(batch, p).points();
    fastest = max(fastest, control_.max_squared_speed(q.stress, q.state[volume_strain], added));
  }
  return {.wave_speed = std::sqrt(maximum(fastest))};
}

} // namespace riedel
