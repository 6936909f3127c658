/// The bodies of RateLaw's member functions; included by rate_law.hpp alone, after the class.
#pragma once

namespace riedel {

/// Eight points' columns, copied in and out; a batch's last group may have fewer.
template <class Law>
struct RateLaw<Law>::Lanes {
  const MaterialBatch& batch;
  const Index first;
  const int used = static_cast<int>(std::min<Index>(pack_size, batch.size - first));

  [[nodiscard]] Pack load(const double* column) const {
    if (used == pack_size) return Pack::load(column + first);
    std::array<double, pack_size> lane;
    for (int k = 0; k < pack_size; ++k) lane[k] = column[first + std::min(k, used - 1)];
    return Pack::load(lane.data());
  }
  void store(double* column, const Pack& value) const {
    if (used == pack_size) return value.store(column + first);
    std::array<double, pack_size> lane;
    value.store(lane.data());
    std::copy_n(lane.data(), used, column + first);
  }
  [[nodiscard]] Point<Pack> point() const {
    Point<Pack> q;
    for (std::size_t c = 0; c < 6; ++c) q.stress.m[c] = load(batch.stress[c]);
    for (std::size_t s = 0; s < Law::own_states; ++s) q.state[s] = load(batch.state[s]);
    return q;
  }
  void put(const Point<Pack>& q) const {
    for (std::size_t c = 0; c < 6; ++c) store(batch.stress[c], q.stress.m[c]);
    for (std::size_t s = 0; s < Law::own_states; ++s) store(batch.state[s], q.state[s]);
  }
  [[nodiscard]] Sym<Pack> rate() const {
    Sym<Pack> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = load(batch.rate[c]);
    return D;
  }
  [[nodiscard]] Point<double> point_alone(int lane) const {
    Point<double> q;
    for (std::size_t c = 0; c < 6; ++c) q.stress.m[c] = batch.stress[c][first + lane];
    for (std::size_t s = 0; s < Law::own_states; ++s) q.state[s] = batch.state[s][first + lane];
    if constexpr (Law::frictional) q.separation = batch.state[Law::own_states][first + lane];
    return q;
  }
  void put_alone(int lane, const Point<double>& q) const {
    for (std::size_t c = 0; c < 6; ++c) batch.stress[c][first + lane] = q.stress.m[c];
    for (std::size_t s = 0; s < Law::own_states; ++s) batch.state[s][first + lane] = q.state[s];
    if constexpr (Law::frictional) batch.state[Law::own_states][first + lane] = q.separation;
  }
  [[nodiscard]] Sym<double> rate_alone(int lane) const {
    Sym<double> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = batch.rate[c][first + lane];
    return D;
  }
};

template <class Law>
template <class Real>
auto RateLaw<Law>::heun(const Point<Real>& start, const Sym<Real>& D, Real d, double dt) const -> Increment<Real> {
  const auto first = law().rate(start.stress, start.state, D, d);
  Point<Real> middle = start;
  middle.stress = start.stress + Real(dt) * first.stress;
  for (std::size_t s = 0; s < Law::own_states; ++s) middle.state[s] += Real(dt) * first.state[s];

  const auto second = law().rate(middle.stress, middle.state, D, d);
  Increment<Real> step{.end = start, .error = Real(0.0)};
  step.end.stress = start.stress + Real(0.5 * dt) * (first.stress + second.stress);
  for (std::size_t s = 0; s < Law::own_states; ++s) step.end.state[s] += Real(0.5 * dt) * (first.state[s] + second.state[s]);
  step.error = Real(0.5 * dt) * norm(second.stress - first.stress) / max(norm(step.end.stress), Real(1e-6));
  return step;
}

template <class Law>
void RateLaw<Law>::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  const Pack tolerance(control_.tolerance), least_trace(3.0 * control_.minimum_pressure);
  for (Index p = 0; p < batch.size; p += pack_size) {
    const Lanes group{batch, p};
    const Point<Pack> start = group.point();
    const Sym<Pack> D = group.rate();
    const Pack d = batch.averaged ? group.load(batch.averaged) : norm(D);
    const Increment<Pack> step = heun(start, D, d, batch.time_step);

    Mask good = step.error <= tolerance; // false for NaN too
    if constexpr (Law::frictional)
      good = good && -trace(start.stress) >= least_trace && -trace(step.end.stress) >= least_trace &&
             group.load(batch.state[Law::own_states]) <= Pack(0.0);
    if (all(good)) group.put(step.end);
    else integrate_mixed(group, step.end, lanes(good), d, report);
  }
}

/// Keeps the good lanes' common step and integrates the others alone.
template <class Law>
void RateLaw<Law>::integrate_mixed(const Lanes& group, const Point<Pack>& common, const std::array<bool, pack_size>& good,
                                   const Pack& d, MaterialReport& report) const {
  std::array<Point<double>, pack_size> alone;
  std::array<double, pack_size> rate_norm;
  d.store(rate_norm.data());
  for (int k = 0; k < group.used; ++k) {
    if (good[k]) continue;
    alone[k] = group.point_alone(k);
    const Step over{.D = group.rate_alone(k), .d = rate_norm[k], .time = group.batch.time_step};
    const std::string_view why = advance_alone(alone[k], over, report);
    if (why.empty()) continue;
    if (report.failures++ == 0) report.first_failure = group.first + k, report.reason = why;
    alone[k] = group.point_alone(k);
  }
  group.put(common);
  for (int k = 0; k < group.used; ++k)
    if (!good[k]) group.put_alone(k, alone[k]);
}

/// Sub-steps one point through the step. @return why it could not be done, or nothing
template <class Law>
std::string_view RateLaw<Law>::advance_alone(Point<double>& point, const Step& over, MaterialReport& report) const {
  constexpr double smallest_share = 1e-4;
  double left = over.time, share = 1.0;
  bool cut = false;
  while (left > 1e-12 * over.time) {
    if constexpr (Law::frictional) {
      if (point.separation > 0.0) left = drift_apart(point, over, left, report);
      if (left <= 0.0) break;
      if (-trace(point.stress) < least_trace()) point.stress = -control_.minimum_pressure * Sym<double>::identity();
    }
    const double dt = std::min(share * over.time, left);
    const Increment<double> step = heun(point, over.D, over.d, dt);
    if (!(step.error <= control_.tolerance)) {
      if (share < smallest_share) return "the stress misses the tolerance even in 10000 sub-steps";
      share *= std::isfinite(step.error) ? std::clamp(0.9 * std::sqrt(control_.tolerance / step.error), 0.1, 0.5) : 0.1;
      cut = true;
      continue;
    }
    const Sym<double> before = point.stress;
    point = step.end;
    if constexpr (Law::frictional)
      if (-trace(point.stress) < least_trace()) leave_low_pressure(point, before, trace(over.D) * dt, report);
    left -= dt;
    share *= std::clamp(0.9 * std::sqrt(control_.tolerance / std::max(step.error, 1e-300)), 0.5, 4.0);
  }
  report.substepped += cut;
  return {};
}

/// A separated point carries no stress; its state follows the deformation. @return the time left after contact, or 0
template <class Law>
double RateLaw<Law>::drift_apart(Point<double>& point, const Step& over, double left, MaterialReport& report) const {
  const double volume_rate = trace(over.D);
  const bool closes = point.separation + volume_rate * left <= 0.0;
  const double dt = closes ? -point.separation / volume_rate : left;
  const Sym<double> contact = -control_.minimum_pressure * Sym<double>::identity();
  const auto rate = law().rate(contact, point.state, over.D, over.d);
  for (std::size_t s = 0; s < Law::own_states; ++s) point.state[s] += dt * rate.state[s];
  point.separation = closes ? 0.0 : point.separation + volume_rate * left;
  point.stress = closes ? contact : Sym<double>::zero();
  ++report.separated;
  return left - dt;
}

/// p fell below its limit: an expanding point separates, any other keeps its last stress direction at p = p_min.
template <class Law>
void RateLaw<Law>::leave_low_pressure(Point<double>& point, const Sym<double>& before, double volume_strain,
                                      MaterialReport& report) const {
  if (volume_strain > 0.0) {
    point.separation = volume_strain;
    point.stress = Sym<double>::zero();
  } else {
    point.stress = (least_trace() / -trace(before)) * before;
    ++report.low_pressure;
  }
}

} // namespace riedel
