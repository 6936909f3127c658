#include "materials/element/umat_probe.hpp"

#include "core/base/error.hpp"

#include <Eigen/Geometry>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>
#include <unistd.h>

namespace riedel {

namespace {

constexpr int finest_halving = 6; ///< 2⁶ steps serve as the exact solution
constexpr int turns = 8;          ///< steps of a body's rotation: each by at most 22.5°

/// From 11, 22, 33, 12, 13, 23; `shear` is the factor from a shear component to Mandel's.
Sym<double> mandel(const std::vector<double>& v, double shear) {
  Sym<double> a;
  for (std::size_t c = 0; c < 6; ++c) a.m[c] = (c < 3 ? 1.0 : shear) * v[c];
  return a;
}

/// One step that takes a second. @throws RunError with the name of the probe
MaterialPoint moved(const Umat& law, const MaterialPoint& from, const Mat<3>& increment, const char* probe) {
  MaterialReport report;
  MaterialPoint to;
  try {
    to = deformed(law, from, increment, 1.0, report);
  } catch (const RunError& error) { throw RunError(std::string("umat-check, ") + probe + ": " + error.what()); }
  if (report.failures > 0) throw RunError(std::string("umat-check, ") + probe + ": " + std::string(report.reason));
  return to;
}

/// A copy of a library in the folder for temporary files, as made for a second thread of a run.
class CopiedFile {
public:
  explicit CopiedFile(const std::string& from) {
    std::error_code error;
    path_ = (std::filesystem::temp_directory_path(error) / "riedel-umat-XXXXXX").string();
    const int file = error ? -1 : mkstemp(path_.data());
    if (file < 0) return;
    close(file);
    made_ = std::filesystem::copy_file(from, path_, std::filesystem::copy_options::overwrite_existing, error);
  }
  ~CopiedFile() {
    std::error_code error;
    if (!path_.empty()) std::filesystem::remove(path_, error);
  }
  CopiedFile(const CopiedFile&) = delete;
  CopiedFile& operator=(const CopiedFile&) = delete;

  [[nodiscard]] bool made() const { return made_; }
  [[nodiscard]] const std::string& path() const { return path_; }

private:
  std::string path_;
  bool made_ = false;
};

/// The larger one, or the one that is NaN.
double worse(double a, double b) { return b <= a ? a : b; }

/// W with W x = w × x.
Mat<3> spin_about(const Vec<3>& w) {
  Mat<3> W;
  W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
  return W;
}

double norm_of(const double* numbers, int count) {
  return std::sqrt(std::inner_product(numbers, numbers + count, numbers, 0.0));
}

/// |a − b|, over the change from `start` to b, or over a small fraction of b if it hardly changes; within a state.
double relative(const double* a, const double* b, const double* start, int count) {
  constexpr double share = 1e-4;
  std::array<double, 6> off{}, change{};
  for (int c = 0; c < count; ++c)
    off[static_cast<std::size_t>(c)] = a[c] - b[c], change[static_cast<std::size_t>(c)] = b[c] - start[c];
  const double size = std::max(norm_of(change.data(), count), share * norm_of(b, count));
  const double error = norm_of(off.data(), count);
  return error == 0.0 ? 0.0 : error / size;
}

} // namespace

UmatProbe::UmatProbe(const Values& material, const std::vector<double>& stress, const std::vector<double>& strain)
    : material_(material),
      law_(material),
      stress_(mandel(stress, std::numbers::sqrt2)),
      strain_(mandel(strain, std::numbers::sqrt2 / 2)) {
  if (norm(strain_) == 0.0) throw InputError("check.strain is zero; allowed: an increment of strain");
}

MaterialPoint UmatProbe::start() const { return {.stress = stress_, .state = law_.initial_state()}; }

MaterialPoint UmatProbe::strained(const Umat& law, MaterialPoint point, const Sym<double>& strain, int steps,
                                  const char* probe) const {
  const Mat<3> part = to_matrix(strain / static_cast<double>(steps));
  for (int i = 0; i < steps; ++i) point = moved(law, point, part, probe);
  return point;
}

double UmatProbe::change() const {
  return norm(strained(law_, start(), strain_, 1, "one step of the strain").stress - stress_);
}

void UmatProbe::one_step() const {
  if (change() == 0.0)
    throw RunError(
        "umat-check, one step of the strain: the UMAT returned the stress that it was given; it does nothing");
}

double UmatProbe::wave_speed() const {
  const char* const probe = "umat-check, DDSDDE of a call without strain: ";
  try {
    const double speed = assess(law_, start()).wave_speed;
    if (speed > 0.0) return speed;
  } catch (const RunError& error) { throw RunError(probe + std::string(error.what())); }
  throw RunError(std::string(probe) + "the UMAT returned no stiffness, from which the time step of a run is computed");
}

double UmatProbe::idle_change() const {
  return norm(strained(law_, start(), Sym<double>::zero(), 1, "a step without strain").stress - stress_) / change();
}

void UmatProbe::compare(const MaterialPoint& there, const MaterialPoint& expected,
                        std::vector<Disagreement>& worst) const {
  const double change = norm(expected.stress - stress_);
  worst.front().error = worse(worst.front().error, norm(there.stress - expected.stress) / change);
  const MaterialPoint from = start();
  std::size_t column = 0, variable = 1;
  for (const StateVariable& state : law_.states()) {
    if (variable == worst.size()) break; // the total strain does not come from the UMAT
    const double error = relative(&there.state[column], &expected.state[column], &from.state[column], state.components);
    worst[variable].error = worse(worst[variable].error, error);
    column += static_cast<std::size_t>(state.components);
    ++variable;
  }
}

std::vector<Disagreement> UmatProbe::rotation_errors() const {
  const char* const probe = "a turn and then the strain";
  std::vector<Disagreement> worst{{.of = "the stress"}};
  for (std::size_t v = 0; v + 1 < law_.states().size(); ++v)
    worst.push_back({.of = "STATEV " + law_.states()[v].name, .declared = v < law_.declared_states()});
  MaterialPoint still = start();
  for (int i = 0; i < turns; ++i) still = moved(law_, still, Mat<3>::Zero(), probe);
  const MaterialPoint reference = strained(law_, still, strain_, 1, probe);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 6; ++i) {
    const Eigen::AngleAxisd turn(Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized());
    const Mat<3> Q = turn.toRotationMatrix(), spin = spin_about(turn.angle() / turns * turn.axis());
    MaterialPoint there = start();
    for (int k = 0; k < turns; ++k) there = moved(law_, there, spin, probe);
    there = moved(law_, there, Q * to_matrix(strain_) * Q.transpose(), probe);
    rotate_tensors(law_, there, Q.transpose());
    compare(there, reference, worst);
  }
  return worst;
}

std::vector<double> UmatProbe::halving_errors() const {
  const char* const probe = "smaller steps";
  const Sym<double> exact = strained(law_, start(), strain_, 1 << finest_halving, probe).stress;
  std::vector<double> errors;
  for (int halving = 0; halving < finest_halving - 1; ++halving)
    errors.push_back(norm(strained(law_, start(), strain_, 1 << halving, probe).stress - exact) / change());
  return errors;
}

double UmatProbe::stiffness_error() const {
  const char* const probe = "DDSDDE against difference quotients";
  std::array<double, 36> given{};
  with_batch(law_, start(), to_matrix(strain_), 1.0,
             [&](const MaterialBatch& batch) { given = law_.stiffness(batch, 0); });
  double worst = 0.0, maximum = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    Sym<double> more = strain_, less = strain_; // a unit of engineering shear is 1/√2 in Mandel's components
    const double step = 1e-3 * norm(strain_), unit = j < 3 ? 1.0 : std::numbers::sqrt2 / 2;
    more.m[j] += unit * step;
    less.m[j] -= unit * step;
    const Sym<double> slope =
        (strained(law_, start(), more, 1, probe).stress - strained(law_, start(), less, 1, probe).stress) / (2 * step);
    for (std::size_t i = 0; i < 6; ++i) {
      const double measured = (i < 3 ? 1.0 : std::numbers::sqrt2 / 2) * slope.m[i];
      worst = worse(worst, std::abs(given[j * 6 + i] - measured));
      maximum = std::max(maximum, std::abs(measured));
    }
  }
  return worst / maximum;
}

std::optional<double> UmatProbe::copy_difference() const {
  const char* const probe = "a second copy of the library";
  const CopiedFile copy(material_.text("library"));
  if (!copy.made()) return std::nullopt;
  Values with_copy = material_;
  with_copy.set("library", copy.path());
  const Umat another(with_copy);
  return norm(strained(another, start(), strain_, 1, probe).stress -
              strained(law_, start(), strain_, 1, probe).stress) /
         change();
}

double UmatProbe::nanoseconds() const {
  constexpr int calls = 20000;
  std::chrono::duration<double, std::nano> spent{};
  with_batch(law_, start(), to_matrix(strain_), 1.0, [&](const MaterialBatch& batch) {
    MaterialReport report;
    const auto from = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) {
      for (std::size_t c = 0; c < 6; ++c) *batch.stress[c] = stress_.m[c]; // the state may drift; the cost is the same
      law_.integrate(batch, report);
    }
    spent = std::chrono::steady_clock::now() - from;
  });
  return spent.count() / calls;
}

} // namespace riedel
