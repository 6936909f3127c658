/// The bodies of RateLaw's member functions; part of rate_law.hpp, after the class.

namespace riedel {

/// Whether one evaluation of the rate is enough for a step. NaN counts as a large change.
template <class Law, std::size_t States>
template <class Real>
auto RateLaw<Law, States>::changes_little(const Point<Real>& start, const Point<Real>& end) const -> MaskOf<Real> {
  const Sym<Real> change = end.stress - start.stress;
  if constexpr (HasConstantRate<Law>) {
    Real size = dot(change, change);
    for (std::size_t s = 0; s < States; ++s) size += abs(end.state[s]);
    return size <= Real(std::numeric_limits<double>::max());
  }
  const double share = 4.0 * control_.tolerance;
  MaskOf<Real> little = dot(change, change) <= Real(share * share) * dot(seen(start.stress), seen(start.stress));
  if constexpr (MeasuresState<Law, States>) return little && law().state_change(start.state, end.state) <= Real(share);
  for (std::size_t s = 0; s < States; ++s)
    little = little && abs(end.state[s] - start.state[s]) <= Real(share) * abs(start.state[s]);
  return little;
}

/// The largest of the relative errors of stress and state; NaN if the state is NaN.
template <class Law, std::size_t States>
template <class Real>
Real RateLaw<Law, States>::error(const Point<Real>& start, const PairStep<Real, States>& step) const {
  const auto& [end, embedded] = step;
  Real maximum = norm(end.stress - embedded.stress) / max(norm(seen(end.stress)), Real(1e-6));
  if constexpr (MeasuresState<Law, States>) {
    maximum = max(maximum, law().state_change(embedded.state, end.state));
  } else {
    for (std::size_t s = 0; s < States; ++s) {
      const Real size = max(max(abs(start.state[s]), abs(end.state[s])), Real(1e-300));
      maximum = max(maximum, abs(end.state[s] - embedded.state[s]) / size);
    }
  }
  for (std::size_t s = 0; s < States; ++s) maximum += Real(0.0) * end.state[s];
  return maximum;
}

/// One evaluation or two, lane by lane; points near zero pressure are left to the integration one by one.
template <class Law, std::size_t States>
template <class Real>
[[gnu::flatten]] auto RateLaw<Law, States>::attempt(const Point<Real>& start, const Real& separation,
                                                    const Step<Real>& over) const -> Trial<Real> {
  const auto first = rate(start, over);
  Trial<Real> trial;
  trial.end = moved(start, first, over.time);
  trial.good = changes_little(start, trial.end);
  trial.twice = !trial.good;
  const Real minimum(min_trace());
  if constexpr (Law::frictional)
    trial.twice = trial.twice && -trace(start.stress) >= minimum && separation <= Real(0.0);
  if (any_lane(trial.twice)) {
    const auto step = heun(start, first, over.time, [&](const Point<Real>& at) { return rate(at, over); });
    trial.end = select(trial.good, trial.end, step.end);
    trial.good = trial.good || (trial.twice && error(start, step) <= Real(control_.tolerance));
  }
  if constexpr (Law::frictional)
    trial.good =
        trial.good && -trace(start.stress) >= minimum && separation <= Real(0.0) && -trace(trial.end.stress) >= minimum;
  return trial;
}

template <class Law, std::size_t States>
void RateLaw<Law, States>::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  using Real = std::conditional_t<RunsOnPacks<Law, States>, Pack, double>;
  for (Index p = 0; p < batch.size; p += lane_count<Real>) {
    const BatchGroup<Real, States> group(batch, p);
    const Point<Real> start = group.points();
    const Trial<Real> trial = attempt(start, separation(group), step_of(group));
    if (all(trial.good) && !any_lane(trial.twice)) {
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

} // namespace riedel
