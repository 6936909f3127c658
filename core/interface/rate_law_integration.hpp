/// The bodies of RateLaw's member functions; included by rate_law.hpp alone, after the class.
#pragma once

namespace riedel {

template <class Law, std::size_t States>
template <class Real>
auto RateLaw<Law, States>::heun(const Point<Real>& start, const Sym<Real>& D, Real d, double dt) const
    -> Increment<Real> {
  const auto first = law().rate(start.stress, start.state, D, d);
  Point<Real> middle = start;
  middle.stress = start.stress + Real(dt) * first.stress;
  for (std::size_t s = 0; s < States; ++s) middle.state[s] += Real(dt) * first.state[s];

  const auto second = law().rate(middle.stress, middle.state, D, d);
  Increment<Real> step{.end = start, .error = Real(0.0)};
  step.end.stress = start.stress + Real(0.5 * dt) * (first.stress + second.stress);
  for (std::size_t s = 0; s < States; ++s) step.end.state[s] += Real(0.5 * dt) * (first.state[s] + second.state[s]);
  step.error = Real(0.5 * dt) * norm(second.stress - first.stress) / max(norm(step.end.stress), Real(1e-6));
  return step;
}

template <class Law, std::size_t States>
void RateLaw<Law, States>::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  const Pack tolerance(control_.tolerance), least(least_trace());
  for (Index p = 0; p < batch.size; p += pack_size) {
    const Group group(batch, p);
    const Point<Pack> start = group.points();
    const Sym<Pack> D = group.rate();
    const Pack d = batch.averaged ? group.load(batch.averaged) : norm(D);
    const Increment<Pack> step = heun(start, D, d, batch.time_step);

    Mask good = step.error <= tolerance; // false for NaN too
    if constexpr (Law::frictional)
      good = good && -trace(start.stress) >= least && -trace(step.end.stress) >= least &&
             group.load(group.separation()) <= Pack(0.0);
    if (all(good))
      group.put(step.end);
    else
      integrate_mixed(group, step.end, lanes(good), d, report);
  }
}

/// Keeps the good lanes' common step and integrates the others alone.
template <class Law, std::size_t States>
void RateLaw<Law, States>::integrate_mixed(const Group& group, const Point<Pack>& common,
                                           const std::array<bool, pack_size>& good, const Pack& d,
                                           MaterialReport& report) const {
  std::array<Lone, pack_size> alone;
  std::array<double, pack_size> rate_norm;
  d.store(rate_norm.data());
  for (int k = 0; k < group.size(); ++k) {
    if (good[k]) continue;
    alone[k] = Lone{group.point(k), Law::frictional ? group.separation()[group.first() + k] : 0.0};
    const Lone before = alone[k];
    const Step over{.D = group.rate(k), .d = rate_norm[k], .time = group.time_step()};
    const std::string_view why = advance_alone(alone[k], over, report);
    if (why.empty()) continue;
    if (report.failures++ == 0) report.first_failure = group.first() + k, report.reason = why;
    alone[k] = before;
  }
  group.put(common);
  for (int k = 0; k < group.size(); ++k) {
    if (good[k]) continue;
    group.put(k, alone[k].point);
    if constexpr (Law::frictional) group.separation()[group.first() + k] = alone[k].separation;
  }
}

/// Sub-steps one point through the step. @return why it could not be done, or nothing
template <class Law, std::size_t States>
std::string_view RateLaw<Law, States>::advance_alone(Lone& lone, const Step& over, MaterialReport& report) const {
  constexpr double smallest_share = 1e-4;
  double left = over.time, share = 1.0;
  bool cut = false;
  while (left > 1e-12 * over.time) {
    if constexpr (Law::frictional) {
      if (lone.separation > 0.0) left = drift_apart(lone, over, left, report);
      if (left <= 0.0) break;
      if (-trace(lone.point.stress) < least_trace()) lone.point.stress = contact_stress();
    }
    const double dt = std::min(share * over.time, left);
    const Increment<double> step = heun(lone.point, over.D, over.d, dt);
    if (!(step.error <= control_.tolerance)) {
      if (share < smallest_share) return "the stress misses the tolerance even in 10000 sub-steps";
      share *= std::isfinite(step.error) ? std::clamp(0.9 * std::sqrt(control_.tolerance / step.error), 0.1, 0.5) : 0.1;
      cut = true;
      continue;
    }
    const Sym<double> before = lone.point.stress;
    lone.point = step.end;
    if constexpr (Law::frictional)
      if (-trace(lone.point.stress) < least_trace()) leave_low_pressure(lone, before, trace(over.D) * dt, report);
    left -= dt;
    share *= std::clamp(0.9 * std::sqrt(control_.tolerance / std::max(step.error, 1e-300)), 0.5, 4.0);
  }
  report.substepped += cut;
  return {};
}

/// A separated point carries no stress; its state follows the deformation. @return the time left after contact, or 0
template <class Law, std::size_t States>
double RateLaw<Law, States>::drift_apart(Lone& lone, const Step& over, double left, MaterialReport& report) const {
  const double volume_rate = trace(over.D);
  const bool closes = lone.separation + volume_rate * left <= 0.0;
  const double dt = closes ? -lone.separation / volume_rate : left;
  lone.point.stress = contact_stress();
  lone.point.state = heun(lone.point, over.D, over.d, dt).end.state;
  lone.separation = closes ? 0.0 : lone.separation + volume_rate * left;
  if (!closes) lone.point.stress = Sym<double>::zero();
  ++report.separated;
  return left - dt;
}

/// p fell below its limit: an expanding point separates, any other keeps its last stress direction at p = p_min.
template <class Law, std::size_t States>
void RateLaw<Law, States>::leave_low_pressure(Lone& lone, const Sym<double>& before, double volume_strain,
                                              MaterialReport& report) const {
  if (volume_strain > 0.0) {
    lone.separation = volume_strain;
    lone.point.stress = Sym<double>::zero();
  } else {
    lone.point.stress = (least_trace() / -trace(before)) * before;
    ++report.low_pressure;
  }
}

} // namespace riedel
