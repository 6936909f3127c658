/// The bodies of RateLaw's member functions; included by rate_law.hpp alone, after the class.
#pragma once

namespace riedel {

template <class Law, std::size_t States>
template <class Real>
auto RateLaw<Law, States>::moved(Point<Real> point, const Rate<Real, States>& rate, double time) -> Point<Real> {
  point.stress = point.stress + Real(time) * rate.stress;
  for (std::size_t s = 0; s < States; ++s) point.state[s] += Real(time) * rate.state[s];
  return point;
}

/// Whether one evaluation of the rate is enough for a step. NaN changes much.
template <class Law, std::size_t States>
template <class Real>
auto RateLaw<Law, States>::changes_little(const Point<Real>& start, const Point<Real>& end) const -> Truth<Real> {
  const Sym<Real> change = end.stress - start.stress;
  if constexpr (HasConstantRate<Law>) return dot(change, change) <= Real(std::numeric_limits<double>::max());
  const double share = 4.0 * control_.tolerance;
  Truth<Real> little = dot(change, change) <= Real(share * share) * dot(start.stress, start.stress);
  for (std::size_t s = 0; s < States; ++s)
    little = little && abs(end.state[s] - start.state[s]) <= Real(share) * abs(start.state[s]);
  return little;
}

template <class Law, std::size_t States>
template <class Real>
auto RateLaw<Law, States>::heun(const Point<Real>& start, const Rate<Real, States>& first, const Step<Real>& over) const
    -> Increment<Real> {
  const auto second = rate(moved(start, first, over.time), over);
  Increment<Real> step{.end = moved(moved(start, first, 0.5 * over.time), second, 0.5 * over.time), .error = Real(0.0)};
  step.error = Real(0.5 * over.time) * norm(second.stress - first.stress) / max(norm(step.end.stress), Real(1e-6));
  return step;
}

/// One evaluation or two, lane by lane; points near zero pressure are left to those integrated alone.
template <class Law, std::size_t States>
template <class Real>
[[gnu::flatten]] auto RateLaw<Law, States>::attempt(const Point<Real>& start, const Real& separation,
                                                    const Step<Real>& over) const -> Trial<Real> {
  const auto first = rate(start, over);
  Trial<Real> trial;
  trial.end = moved(start, first, over.time);
  trial.good = changes_little(start, trial.end);
  trial.twice = !trial.good;
  const Real least(least_trace());
  if constexpr (Law::frictional) trial.twice = trial.twice && -trace(start.stress) >= least && separation <= Real(0.0);
  if (some(trial.twice)) {
    const Increment<Real> step = heun(start, first, over);
    trial.end = select(trial.good, trial.end, step.end);
    trial.good = trial.good || (trial.twice && step.error <= Real(control_.tolerance));
  }
  if constexpr (Law::frictional)
    trial.good =
        trial.good && -trace(start.stress) >= least && separation <= Real(0.0) && -trace(trial.end.stress) >= least;
  return trial;
}

template <class Law, std::size_t States>
void RateLaw<Law, States>::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  using Real = std::conditional_t<RunsOnPacks<Law, States>, Pack, double>;
  for (Index p = 0; p < batch.size; p += lane_count<Real>) {
    const BatchGroup<Real, States> group(batch, p);
    const Point<Real> start = group.points();
    const Trial<Real> trial = attempt(start, separation(group), step_of(group));
    if (all(trial.good) && !some(trial.twice)) {
      group.put(trial.end);
      continue;
    }
    group.put(select(trial.good, trial.end, start));
    const auto good = lanes(trial.good), twice = lanes(trial.twice);
    for (int k = 0; k < group.size(); ++k) {
      report.evaluated_twice += twice[k];
      if (!good[k]) integrate_alone(batch, p + k, report);
    }
  }
}

/// With sub-steps. A point that fails keeps its state.
template <class Law, std::size_t States>
void RateLaw<Law, States>::integrate_alone(const MaterialBatch& batch, Index p, MaterialReport& report) const {
  const BatchGroup<double, States> place(batch, p);
  Lone lone{.point = place.points(), .separation = separation(place)};
  const std::string_view why = advance_alone(lone, step_of(place), report);
  if (!why.empty()) {
    if (report.failures++ == 0) report.first_failure = p, report.reason = why;
    return;
  }
  place.put(lone.point);
  if constexpr (Law::frictional) place.store(batch.state[States], lone.separation);
}

/// Sub-steps one point through the step. @return why it could not be done, or nothing
template <class Law, std::size_t States>
std::string_view RateLaw<Law, States>::advance_alone(Lone& lone, const Step<double>& over,
                                                     MaterialReport& report) const {
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
    const Step<double> part{.D = over.D, .d = over.d, .time = dt};
    const Increment<double> step = heun(lone.point, rate(lone.point, part), part);
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
double RateLaw<Law, States>::drift_apart(Lone& lone, Step<double> over, double left, MaterialReport& report) const {
  const double volume_rate = trace(over.D);
  const bool closes = lone.separation + volume_rate * left <= 0.0;
  over.time = closes ? -lone.separation / volume_rate : left;
  lone.point.stress = contact_stress();
  lone.point.state = heun(lone.point, rate(lone.point, over), over).end.state;
  lone.separation = closes ? 0.0 : lone.separation + volume_rate * left;
  if (!closes) lone.point.stress = Sym<double>::zero();
  ++report.separated;
  return left - over.time;
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
