#include "materials/element/point_driver.hpp"

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <limits>

namespace riedel {

namespace {

constexpr double round_off = std::numeric_limits<double>::epsilon();

} // namespace

double Condition::course(double from, double share) const {
  const double wave = swing == 0.0 ? 0.0 : std::sin(2.0 * std::numbers::pi * share + phase) - std::sin(phase);
  return std::lerp(from, target, share) + swing * wave;
}

/// The conditions that one step has to meet at its end.
struct PointDriver::Task {
  const LoadStep& leg;
  const MaterialPoint& start;
  std::array<double, 6> target;
  double share, length; ///< of the leg: completed at the end of the step, and taken by the step
  Allowed allowed;

  /// @param from values of the measures at the start of the leg
  Task(const LoadStep& of, const MaterialPoint& at, const std::array<double, 6>& from, double to, double by,
       const Allowed& error)
      : leg(of), start(at), target(), share(to), length(by), allowed(error) {
    for (std::size_t c = 0; c < 6; ++c) target[c] = of.conditions[c].course(from[c], share);
  }
  [[nodiscard]] double allowed_in(std::size_t c) const {
    return leg.conditions[c].of_stress ? allowed.stress : allowed.strain;
  }
  [[nodiscard]] double time() const { return length * leg.duration; }
  /// L Δt of a prescribed motion: of second order, like the step.
  [[nodiscard]] Mat<3> given_increment() const {
    const Mat<3> change = leg.deformation - Mat<3>::Identity();
    const Mat<3> before = Mat<3>::Identity() + (share - length) * change, after = Mat<3>::Identity() + share * change;
    return 2.0 * (after - before) * (after + before).inverse();
  }
};

namespace {

/// L Δt from its six free numbers, order 11, 22, 33, 12, 13, 23.
Mat<3> increment_of(const Eigen::Matrix<double, 6, 1>& x, LoadStep::Motion motion) {
  Mat<3> L;
  if (motion == LoadStep::Motion::simple_shear)
    L << x[0], x[3], x[4], 0.0, x[1], x[5], 0.0, 0.0, x[2];
  else
    L << x[0], x[3] / 2, x[4] / 2, x[3] / 2, x[1], x[5] / 2, x[4] / 2, x[5] / 2, x[2];
  return L;
}

} // namespace

PointDriver::PointDriver(const Material& law, MaterialPoint start, const PointControl& control)
    : law_(law), control_(control), point_(std::move(start)) {}

/// Limits for the residuals of Newton's method: at most a thousandth of the tolerance, but not below round-off. A law
/// that stores its strain computes stress from it, with the round-off of strain times stiffness.
PointDriver::Allowed PointDriver::allowed() const {
  const double speed = assess(law_, point_).wave_speed;
  const double stiffness = law_.density(point_.state) * speed * speed + control_.added_stiffness;
  const double noise = round_off * (32.0 * norm(point_.stress) + 16.0 * (std::isfinite(stiffness) ? stiffness : 0.0));
  const double stress = std::min(1e-9, 1e-5 * control_.tolerance) * std::max(norm(point_.stress), 1.0);
  return {.noise = noise,
          .stress = std::max(stress, noise),
          .strain = std::max(std::min(1e-12, 1e-6 * control_.tolerance), 16.0 * round_off)};
}

PointDriver::Step PointDriver::moved(const Task& task, const Vector& x, const Mat<3>& L) const {
  Step step{.end = {}, .increment = x, .report = {}, .residual = Vector::Zero(), .size = 0.0};
  step.end = deformed(law_, task.start, L, task.time(), step.report);
  if (step.report.failures > 0) step.size = HUGE_VAL;
  return step;
}

PointDriver::Step PointDriver::attempt(const Task& task, const Vector& x) const {
  Step step = moved(task, x, increment_of(x, task.leg.motion));
  for (std::size_t c = 0; c < 6; ++c) {
    const double r = (task.leg.conditions[c].measure(step.end) - task.target[c]) / task.allowed_in(c);
    step.residual[static_cast<Eigen::Index>(c)] = r;
    step.size = std::max(step.size, std::isfinite(r) ? std::abs(r) : HUGE_VAL);
  }
  if (x.lpNorm<Eigen::Infinity>() > 0.5) step.size = HUGE_VAL;
  return step;
}

/// Difference quotients of the residual. Laws are homogeneous in the rate, so the step is a fraction of the increment.
/// A direction whose quotients are below their round-off, over the largest stiffness, changes nothing.
void PointDriver::take_slopes(const Task& task, const Step& at) {
  const double h = 1e-3 * std::max(at.increment.lpNorm<Eigen::Infinity>(), 1e-7);
  Matrix quotients;
  for (Eigen::Index j = 0; j < 6; ++j)
    quotients.col(j) = (attempt(task, at.increment + h * Vector::Unit(j)).residual - at.residual) / h;
  double stiffness = 1e-300;
  for (std::size_t c = 0; c < 6; ++c)
    if (task.leg.conditions[c].of_stress)
      stiffness = std::max(stiffness, task.allowed.stress * quotients.row(static_cast<Eigen::Index>(c)).norm());
  for (std::size_t c = 0; c < 6; ++c)
    scales_[static_cast<Eigen::Index>(c)] =
        task.leg.conditions[c].of_stress ? task.allowed.stress / stiffness : task.allowed.strain;
  for (Eigen::Index c = 0; c < 6; ++c) quotients.row(c) *= scales_[c];
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(std::clamp(task.allowed.noise / (h * stiffness), 1e-12, 1e-3));
  decomposition.compute(quotients);
  inverse_ = decomposition.pseudoInverse();
}

/// Newton's step with the present slopes; if they are new, it is shortened until it reduces the residual.
PointDriver::Step PointDriver::corrected(const Task& task, const Step& step, bool slopes_are_new) const {
  Vector change = Vector::Zero();
  for (Eigen::Index c = 0; c < 6; ++c) change += scales_[c] * step.residual[c] * inverse_.col(c);
  Step next = attempt(task, step.increment - change);
  for (double part = 0.5; slopes_are_new && part > 0.05 && !(next.size < step.size); part *= 0.5)
    next = attempt(task, step.increment - part * change);
  return next;
}

/// Slopes are kept from step to step as long as each correction leaves less than a fifth of the residual.
std::optional<PointDriver::Step> PointDriver::solve_from(const Task& task, const Vector& guess) {
  constexpr int maximum = 30;
  constexpr double stalled = 30.0; // jumps of the law's answer from other sub-steps
  Step step = attempt(task, guess);
  for (int i = 0; i < maximum && step.size > 1.0; ++i) {
    const bool renewed = !has_slopes_;
    if (renewed) take_slopes(task, step);
    // At rest the law has a slope for each direction, and none of them needs to point downhill.
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
  refused_ = step.report.reason;
  has_slopes_ = false;
  return std::nullopt;
}

/// Line search along a direction for the smallest residual. @return nothing if the direction does not reduce it
std::optional<PointDriver::Vector> PointDriver::scaled(const Task& task, const Vector& direction) const {
  constexpr double h = 1e-7; // laws are homogeneous in the rate
  const Step rest = attempt(task, Vector::Zero());
  const Vector slope = (attempt(task, h * direction).residual - rest.residual) / h;
  const double length = -rest.residual.dot(slope) / slope.squaredNorm();
  if (!(length > 0.0 && length < 0.1)) return std::nullopt;
  return length * direction;
}

std::optional<PointDriver::Step> PointDriver::given_motion(const Task& task) {
  const Mat<3> L = task.given_increment();
  Vector x;
  x << L(0, 0), L(1, 1), L(2, 2), L(0, 1) + L(1, 0), L(0, 2) + L(2, 0), L(1, 2) + L(2, 1);
  Step step = moved(task, x, L);
  if (step.size == 0.0) return step;
  missed_ = "the deformation gradient";
  refused_ = step.report.reason;
  return std::nullopt;
}

/// If Newton's method fails from the guess, it restarts in other directions: a law with different slopes in loading and
/// unloading may hide one behind the other.
std::optional<PointDriver::Step> PointDriver::solve(const Task& task, const Vector& guess) {
  if (task.leg.motion == LoadStep::Motion::given) return given_motion(task);
  if (auto step = solve_from(task, guess)) return step;
  std::vector<Vector> directions{last_direction_, -last_direction_, Vector::Zero()};
  directions.back().head<3>().setConstant(-1.0);
  for (Eigen::Index j = 0; j < 6; ++j) directions.insert(directions.end(), {-Vector::Unit(j), Vector::Unit(j)});
  for (const Vector& direction : directions)
    if (const auto start = scaled(task, direction))
      if (auto step = solve_from(task, *start)) return step;
  return std::nullopt;
}

/// The step from `share` on: in one, and in two halves.
std::optional<PointDriver::Halves> PointDriver::step_and_halves(const LoadStep& leg, const std::array<double, 6>& from,
                                                                double share, double length) {
  const double half = 0.5 * length;
  const Allowed error = allowed();
  missed_.clear();
  const auto whole = solve({leg, point_, from, share + length, length, error}, length * rate_);
  if (!whole) return std::nullopt;
  const auto first = solve({leg, point_, from, share + half, half, error}, 0.5 * whole->increment);
  if (!first) return std::nullopt;
  const auto second = solve({leg, first->end, from, share + length, half, error}, first->increment);
  if (!second) return std::nullopt;
  missed_.clear(); // earlier failures do not matter any more
  return compared(*whole, *first, *second, length, error);
}

/// At a kink, such as the onset of yielding, the error relative to the step does not decrease with its length; there a
/// share of the leg's deformation is the reference. Residuals and round-off are not counted as errors of the step.
PointDriver::Halves PointDriver::compared(const Step& whole, const Step& first, const Step& second, double length,
                                          const Allowed& allowed) const {
  constexpr double kink = 1e-4, residuals = 4.0;
  const double moved = whole.increment.norm(), size = std::max(norm(point_.stress), norm(second.end.stress));
  const double motion =
      (whole.end.F - second.end.F).norm() / (0.5 * control_.tolerance * std::max(moved, kink * moved / length) +
                                             residuals * allowed.strain + 32.0 * round_off * second.end.F.norm());
  const double stress =
      norm(whole.end.stress - second.end.stress) / (0.5 * control_.tolerance * size + residuals * allowed.stress);
  const double change = norm(second.end.stress - point_.stress) / (std::max(size, 1e-6) * control_.largest_change);
  return {.first = first,
          .second = second,
          .error = std::max(stress, motion),
          .change = std::max(length > first_share() ? change : 0.0,
                             whole.increment.lpNorm<Eigen::Infinity>() / control_.largest_strain)};
}

bool PointDriver::follow(const LoadStep& leg, const std::function<bool(const MaterialPoint&)>& go_on) {
  const double smallest_share = std::clamp(1e-4 * control_.tolerance, 8.0 * round_off, 1e-10);
  std::array<double, 6> from{};
  if (leg.motion != LoadStep::Motion::given)
    for (std::size_t c = 0; c < 6; ++c) from[c] = leg.conditions[c].measure(point_);
  if (!rate_.isZero()) last_direction_ = rate_.normalized();
  rate_.setZero();
  has_slopes_ = false;
  for (double share = 0.0, length = first_share(); share < 1.0;) {
    length = std::min(length, control_.largest_share);
    if (share + 1.01 * length > 1.0) length = 1.0 - share;
    const auto step = step_and_halves(leg, from, share, length);
    const double factor =
        step ? 0.9 * std::min(1.0 / std::cbrt(step->error), 1.0 / step->change) : 0.25; // infinite for 0, limited below
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
  const std::string place = short_text(100.0 * share, 4) + " % of this leg (" + where + ")";
  if (missed_.empty()) return "the stress jumps, however short the step, beyond " + place;
  if (!refused_.empty()) return "the law failed beyond " + place + ": " + std::string(refused_);
  return "no deformation gives " + missed_ + " the value that the path requires: the material cannot follow beyond " +
         place + "; it is at its limit state, or stress-free";
}

} // namespace riedel
