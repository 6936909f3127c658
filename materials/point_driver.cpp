#include "materials/point_driver.hpp"

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"

#include <Eigen/LU>

namespace riedel {

/// The conditions at the end of one step.
struct PointDriver::Task {
  const Leg& leg;
  const LawPoint& start;
  std::array<double, 6> target;
  double time;
  double stress_scale; ///< [Pa]

  /// @param from values of the measures at the start of the leg   @param share of the leg at the end of the step
  Task(const Leg& of, const LawPoint& at, const std::array<double, 6>& from, double share, double length)
      : leg(of), start(at), target(), time(length * of.duration), stress_scale(std::max(norm(at.stress), 1.0)) {
    for (std::size_t c = 0; c < 6; ++c) target[c] = std::lerp(from[c], of.conditions[c].target, share);
  }
  [[nodiscard]] double allowed(std::size_t c) const {
    return leg.conditions[c].of_stress ? 1e-9 * stress_scale : 1e-12;
  }
};

namespace {

/// L Δt from its six free numbers, order 11, 22, 33, 12, 13, 23.
Mat<3> increment_of(const Eigen::Matrix<double, 6, 1>& x, Leg::Motion motion) {
  Mat<3> L;
  if (motion == Leg::Motion::simple_shear)
    L << x[0], x[3], x[4], 0.0, x[1], x[5], 0.0, 0.0, x[2];
  else
    L << x[0], x[3] / 2, x[4] / 2, x[3] / 2, x[1], x[5] / 2, x[4] / 2, x[5] / 2, x[2];
  return L;
}

} // namespace

PointDriver::PointDriver(const Material& law, LawPoint start, const PointControl& control)
    : law_(law), control_(control), point_(std::move(start)) {}

PointDriver::Step PointDriver::attempt(const Task& task, const Vector& x) const {
  Step step{.end = {}, .increment = x, .report = {}, .residual = Vector::Zero(), .size = 0.0};
  step.end = deformed(law_, task.start, increment_of(x, task.leg.motion), task.time, step.report);
  for (std::size_t c = 0; c < 6; ++c) {
    const double r = (task.leg.conditions[c].measure(step.end) - task.target[c]) / task.allowed(c);
    step.residual[static_cast<Eigen::Index>(c)] = r;
    step.size = std::max(step.size, std::isfinite(r) ? std::abs(r) : HUGE_VAL);
  }
  if (step.report.failures > 0 || x.lpNorm<Eigen::Infinity>() > 0.5) step.size = HUGE_VAL;
  return step;
}

/// Difference quotients of the residual. Laws are homogeneous in the rate, so the step is a share of the increment.
PointDriver::Matrix PointDriver::slopes(const Task& task, const Step& at) const {
  const double h = 1e-3 * std::max(at.increment.lpNorm<Eigen::Infinity>(), 1e-7);
  Matrix quotients;
  for (Eigen::Index j = 0; j < 6; ++j)
    quotients.col(j) = (attempt(task, at.increment + h * Vector::Unit(j)).residual - at.residual) / h;
  for (Eigen::Index c = 0; c < 6; ++c) quotients.row(c) *= task.allowed(static_cast<std::size_t>(c)); // free of scale
  return quotients;
}

/// Newton's step with the slopes at hand; where they are new, it is shortened until it helps.
PointDriver::Step PointDriver::corrected(const Task& task, const Step& step, bool slopes_are_new) const {
  Vector residual = step.residual;
  for (Eigen::Index c = 0; c < 6; ++c) residual[c] *= task.allowed(static_cast<std::size_t>(c));
  const Vector change = slopes_.partialPivLu().solve(residual);
  Step next = attempt(task, step.increment - change);
  for (double part = 0.5; slopes_are_new && part > 0.05 && !(next.size < step.size); part *= 0.5)
    next = attempt(task, step.increment - part * change);
  return next;
}

/// Slopes are kept from step to step as long as each correction leaves less than a fifth of the residual.
std::optional<PointDriver::Step> PointDriver::solve_from(const Task& task, const Vector& guess) {
  constexpr int most = 30;
  constexpr double stalled = 30.0; // where the law cuts its sub-steps otherwise, its answer jumps by so little
  Step step = attempt(task, guess);
  for (int i = 0; i < most && step.size > 1.0; ++i) {
    const bool renewed = !has_slopes_;
    if (renewed) slopes_ = slopes(task, step);
    // At rest the law has a slope for each direction, and none of them need point downhill.
    const bool at_rest = step.increment.isZero();
    const Step next = corrected(task, step, renewed && !at_rest);
    const bool helped = next.size < 0.9 * step.size || (at_rest && next.size < HUGE_VAL);
    has_slopes_ = next.size < 0.2 * step.size;
    if (helped) step = next;
    if (!helped && renewed) break;
  }
  if (step.size <= stalled) return step;
  Eigen::Index worst = 0;
  step.residual.cwiseAbs().maxCoeff(&worst);
  missed_ = task.leg.conditions[static_cast<std::size_t>(worst)].name;
  has_slopes_ = false;
  return std::nullopt;
}

/// So much of a direction that the residual becomes as small as it can. @return nothing where that is no way forward
std::optional<PointDriver::Vector> PointDriver::scaled(const Task& task, const Vector& direction) const {
  constexpr double h = 1e-7; // laws are homogeneous in the rate
  const Step rest = attempt(task, Vector::Zero());
  const Vector slope = (attempt(task, h * direction).residual - rest.residual) / h;
  const double length = -rest.residual.dot(slope) / slope.squaredNorm();
  if (!(length > 0.0 && length < 0.1)) return std::nullopt;
  return length * direction;
}

/// Where Newton's method fails from the guess, it starts anew in other directions: a law that answers loading and
/// unloading with different slopes may hide the one behind the other.
std::optional<PointDriver::Step> PointDriver::solve(const Task& task, const Vector& guess) {
  if (auto step = solve_from(task, guess)) return step;
  std::vector<Vector> directions{last_direction_, -last_direction_, Vector::Zero()};
  directions.back().head<3>().setConstant(-1.0);
  for (Eigen::Index j = 0; j < 6; ++j) directions.insert(directions.end(), {-Vector::Unit(j), Vector::Unit(j)});
  for (const Vector& direction : directions)
    if (const auto start = scaled(task, direction))
      if (auto step = solve_from(task, *start)) return step;
  return std::nullopt;
}

/// The step from `share` on: whole, and in two halves.
std::optional<PointDriver::Halves> PointDriver::step_and_halves(const Leg& leg, const std::array<double, 6>& from,
                                                                double share, double length) {
  const double half = 0.5 * length;
  const auto whole = solve({leg, point_, from, share + length, length}, length * rate_);
  if (!whole) return std::nullopt;
  const auto first = solve({leg, point_, from, share + half, half}, 0.5 * whole->increment);
  if (!first) return std::nullopt;
  const auto second = solve({leg, first->end, from, share + length, half}, first->increment);
  if (!second) return std::nullopt;
  const double size = std::max({norm(point_.stress), norm(second->end.stress), 1e-6});
  const double stress = norm(whole->end.stress - second->end.stress) / size;
  const double motion = (whole->end.F - second->end.F).norm() / std::max(whole->increment.norm(), 1e-300);
  const double change = norm(second->end.stress - point_.stress) / (size * control_.largest_change);
  return Halves{.first = *first,
                .second = *second,
                .error = std::max(stress, motion) / (3.0 * control_.tolerance),
                .change = std::max(length > first_share() ? change : 0.0,
                                   whole->increment.lpNorm<Eigen::Infinity>() / control_.largest_strain)};
}

bool PointDriver::follow(const Leg& leg, const std::function<bool(const LawPoint&)>& go_on) {
  constexpr double smallest_share = 1e-10;
  std::array<double, 6> from{};
  for (std::size_t c = 0; c < 6; ++c) from[c] = leg.conditions[c].measure(point_);
  if (!rate_.isZero()) last_direction_ = rate_.normalized();
  rate_.setZero();
  has_slopes_ = false;
  for (double share = 0.0, length = first_share(); share < 1.0;) {
    length = std::min(length, control_.largest_share);
    if (share + 1.01 * length > 1.0) length = 1.0 - share;
    const auto step = step_and_halves(leg, from, share, length);
    const double factor =
        step ? 0.9 * std::min(1.0 / std::cbrt(step->error), 1.0 / step->change) : 0.25; // infinite of 0, cut below
    if (step && step->error <= 1.0 && step->change <= 1.0) {
      keep(*step, length);
      share = length == 1.0 - share ? 1.0 : share + length;
      if (!go_on(point_)) return share == 1.0;
    }
    length *= std::clamp(factor, 0.2, 2.0);
    if (length < smallest_share) throw RunError(lost(share));
  }
  return true;
}

void PointDriver::keep(const Halves& step, double length) {
  point_ = step.second.end;
  rate_ = 2.0 / length * step.second.increment;
  report_.add(step.first.report, 0);
  report_.add(step.second.report, 0);
  ++steps_;
}

std::string PointDriver::lost(double share) const {
  std::string where;
  for (int a = 0; a < 3; ++a)
    where += "eps_" + std::to_string(a + 1) + " = " + short_text(1.0 - point_.F(a, a), 4) + ", ";
  for (int a = 0; a < 3; ++a)
    where += (a ? ", " : "") + ("sigma_" + std::to_string(a + 1)) + " = " + short_text(-point_.stress.m[a], 4) + " Pa";
  return "no deformation gives " + missed_ + " what the path asks for: the material cannot follow beyond " +
         short_text(100.0 * share, 4) + " % of this leg (" + where + "); it is at its limit state, or without stress";
}

} // namespace riedel
