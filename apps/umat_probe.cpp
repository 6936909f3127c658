#include "apps/umat_probe.hpp"

#include "core/base/error.hpp"
#include "core/step/rotation.hpp"

#include <Eigen/Geometry>
#include <chrono>
#include <random>

namespace riedel {

namespace {

constexpr int finest_halving = 6; ///< 2⁶ steps stand for the exact answer

/// From 11, 22, 33, 12, 13, 23; `shear` turns a shear component into Mandel's.
Sym<double> mandel(const std::vector<double>& v, double shear) {
  Sym<double> a;
  for (std::size_t c = 0; c < 6; ++c) a.m[c] = (c < 3 ? 1.0 : shear) * v[c];
  return a;
}

/// A point as the columns of a batch.
struct OnePoint {
  std::array<double*, 6> stress{};
  std::array<const double*, 6> rate{};
  std::vector<double*> state;

  template <class State>
  OnePoint(State& point, const Sym<double>& strain) {
    for (std::size_t c = 0; c < 6; ++c) stress[c] = &point.stress.m[c], rate[c] = &strain.m[c];
    for (double& value : point.state) state.push_back(&value);
  }
  [[nodiscard]] MaterialBatch batch() const {
    return {.size = 1, .time_step = 1.0, .stress = stress, .rate = rate, .state = state};
  }
};

} // namespace

UmatProbe::UmatProbe(const Values& material, const std::vector<double>& stress, const std::vector<double>& strain)
    : material_(material),
      law_(material),
      stress_(mandel(stress, std::numbers::sqrt2)),
      strain_(mandel(strain, std::numbers::sqrt2 / 2)) {}

UmatProbe::State UmatProbe::start() const { return {stress_, law_.initial_state()}; }

UmatProbe::State UmatProbe::advanced(const Umat& law, State from, const Sym<double>& strain, int steps) const {
  const Sym<double> part = strain / static_cast<double>(steps);
  const OnePoint point(from, part);
  for (int i = 0; i < steps; ++i) {
    MaterialReport report;
    law.integrate(point.batch(), report);
    if (report.failures > 0) throw RunError("umat-check: " + std::string(report.reason));
  }
  return from;
}

UmatProbe::State UmatProbe::turned(State point, const Mat<3>& Q) const {
  point.stress = rotated(point.stress, Q);
  std::size_t column = 0;
  for (const StateVariable& variable : law_.states()) {
    if (variable.components == 6) {
      Sym<double> a;
      std::copy_n(point.state.begin() + static_cast<std::ptrdiff_t>(column), 6, a.m.begin());
      a = rotated(a, Q);
      std::copy_n(a.m.begin(), 6, point.state.begin() + static_cast<std::ptrdiff_t>(column));
    }
    column += static_cast<std::size_t>(variable.components);
  }
  return point;
}

double UmatProbe::change() const { return norm(advanced(law_, start(), strain_, 1).stress - stress_); }

double UmatProbe::wave_speed() const {
  State point = start();
  return law_.survey(OnePoint(point, strain_).batch()).wave_speed;
}

double UmatProbe::idle_change() const {
  return norm(advanced(law_, start(), Sym<double>::zero(), 1).stress - stress_) / change();
}

double UmatProbe::rotation_error() const {
  const State reference = advanced(law_, start(), strain_, 1);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 6; ++i) {
    const Mat<3> Q = Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized().matrix();
    const State there = advanced(law_, turned(start(), Q), rotated(strain_, Q), 1), expected = turned(reference, Q);
    worst = std::max(worst, norm(there.stress - expected.stress) / change());
    for (std::size_t s = 0; s < expected.state.size(); ++s)
      worst = std::max(worst, std::abs(there.state[s] - expected.state[s]) / (1.0 + std::abs(expected.state[s])));
  }
  return worst;
}

std::vector<double> UmatProbe::halving_errors() const {
  const Sym<double> exact = advanced(law_, start(), strain_, 1 << finest_halving).stress;
  std::vector<double> errors;
  for (int halving = 0; halving < finest_halving - 1; ++halving)
    errors.push_back(norm(advanced(law_, start(), strain_, 1 << halving).stress - exact) / change());
  return errors;
}

double UmatProbe::stiffness_error() const {
  State point = start();
  const std::array<double, 36> given = law_.stiffness(OnePoint(point, strain_).batch(), 0);
  double worst = 0.0, greatest = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    Sym<double> more = strain_, less = strain_; // a unit of engineering shear is 1/√2 in Mandel's components
    const double step = 1e-3 * norm(strain_), unit = j < 3 ? 1.0 : std::numbers::sqrt2 / 2;
    more.m[j] += unit * step;
    less.m[j] -= unit * step;
    const Sym<double> slope =
        (advanced(law_, start(), more, 1).stress - advanced(law_, start(), less, 1).stress) / (2 * step);
    for (std::size_t i = 0; i < 6; ++i) {
      const double measured = (i < 3 ? 1.0 : std::numbers::sqrt2 / 2) * slope.m[i];
      worst = std::max(worst, std::abs(given[j * 6 + i] - measured));
      greatest = std::max(greatest, std::abs(measured));
    }
  }
  return worst / greatest;
}

double UmatProbe::copy_difference() const {
  const Umat another(material_);
  return norm(advanced(another, start(), strain_, 1).stress - advanced(law_, start(), strain_, 1).stress) / change();
}

double UmatProbe::nanoseconds() const {
  constexpr int calls = 20000;
  State point = start();
  const OnePoint columns(point, strain_);
  MaterialReport report;
  const auto from = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) {
    point.stress = stress_; // the state may drift; it costs the same
    law_.integrate(columns.batch(), report);
  }
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - from).count() / calls;
}

} // namespace riedel
