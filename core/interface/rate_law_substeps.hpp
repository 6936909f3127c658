/// The bodies of RateLaw's member functions for points integrated alone; included by rate_law.hpp alone, after the
/// class.
#pragma once

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
      if (share < smallest_share) return "the tolerance is missed even in 10000 sub-steps";
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
  if constexpr (LivesInContacts<Law, States>) law().lose_contact(lone.point.state);
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
