/// The bodies of RateLaw's member functions for points integrated alone; part of rate_law.hpp, after the class.

namespace riedel {

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

/// Integrates one point over the step in sub-steps. @return why that failed, or empty
template <class Law, std::size_t States>
std::string_view RateLaw<Law, States>::advance_alone(Lone& lone, const Step<double>& over,
                                                     MaterialReport& report) const {
  constexpr double smallest_share = 1e-4;
  const double allowed =
      control_.tolerance / 8.0; // so that the errors of sub-steps of order 3 add up to about the tolerance
  const auto rate_at = [&](const Point<double>& at) { return rate(at, over); };
  std::optional<Rate<double, States>> first; // at the start of the sub-step, if known
  double left = over.time, share = 1.0;
  bool cut = false;
  while (left > 1e-12 * over.time) {
    if constexpr (Law::frictional) {
      if (lone.separation > 0.0) left = move_stress_free(lone, over, left, report), first.reset();
      if (left <= 0.0) break;
      if (-trace(lone.point.stress) < min_trace()) lone.point.stress = contact_stress(), first.reset();
    }
    if (!first) first = rate_at(lone.point);
    const double dt = std::min(share * over.time, left);
    const auto step = bogacki_shampine(lone.point, *first, dt, rate_at);
    const double missed = error(lone.point, step) / allowed;
    if (!(missed <= 1.0)) {
      if (share < smallest_share) return "the tolerance is missed even with 10000 sub-steps";
      share *= std::isfinite(missed) ? std::clamp(0.9 / std::cbrt(missed), 0.1, 0.5) : 0.1;
      ++report.rejected_substeps;
      cut = true;
      continue;
    }
    const Sym<double> before = lone.point.stress;
    lone.point = step.end;
    first = step.last;
    if constexpr (Law::frictional)
      if (-trace(lone.point.stress) < min_trace())
        leave_low_pressure(lone, before, trace(over.D) * dt, report), first.reset();
    left -= dt;
    share *= std::clamp(0.9 / std::cbrt(missed), 0.5, 4.0); // infinite for 0
    ++report.substeps;
  }
  report.substepped += cut;
  return {};
}

/// A separated point is stress-free; its state follows the deformation. @return the time left after contact, or 0
template <class Law, std::size_t States>
double RateLaw<Law, States>::move_stress_free(Lone& lone, Step<double> over, double left,
                                              MaterialReport& report) const {
  const double volume_rate = trace(over.D);
  const bool closes = lone.separation + volume_rate * left <= 0.0;
  over.time = closes ? -lone.separation / volume_rate : left;
  const auto without_stress = [&](Point<double> at) {
    at.stress = contact_stress();
    return rate(at, over);
  };
  lone.point.state = bogacki_shampine(lone.point, without_stress(lone.point), over.time, without_stress).end.state;
  lone.point.stress = closes ? contact_stress() : Sym<double>::zero();
  if constexpr (LivesInContacts<Law, States>) law().lose_contact(lone.point.state);
  lone.separation = closes ? 0.0 : lone.separation + volume_rate * left;
  ++report.separated;
  return left - over.time;
}

/// p + p_t has fallen below its limit: an expanding point separates, any other keeps the last direction of the stress.
template <class Law, std::size_t States>
void RateLaw<Law, States>::leave_low_pressure(Lone& lone, const Sym<double>& before, double volume_strain,
                                              MaterialReport& report) const {
  if (volume_strain > 0.0) {
    lone.separation = volume_strain;
    lone.point.stress = Sym<double>::zero();
  } else {
    const Sym<double> last = seen(before);
    lone.point.stress = (3.0 * control_.minimum_pressure / -trace(last)) * last;
    for (std::size_t c = 0; c < 3; ++c) lone.point.stress.m[c] += control_.cohesion_pressure;
    ++report.low_pressure;
  }
}

} // namespace riedel
