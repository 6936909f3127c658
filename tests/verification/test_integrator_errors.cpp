/// Errors and orders of the methods that integrate rate laws, on the strain path of a dense plane strain test that is
/// cut into straight increments. Prints the tables of docs/verification.md.
#include "support/csv.hpp"
#include "support/law.hpp"
#include "verification/plane_strain_path.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

Values sand_values(double tolerance = 1e-4) {
  Values values(GudehusBauer::parameters());
  values.set("tolerance", tolerance);
  return values;
}

/// The law, with its rates counted.
class CountedSand final : public RateLaw<CountedSand, 1> {
public:
  static constexpr bool frictional = true;
  explicit CountedSand(double tolerance)
      : RateLaw(IntegrationControl(sand_values(tolerance))), sand_(sand_values(tolerance)) {}

  [[nodiscard]] Rate<double, 1> rate(const Sym<double>& sigma, const std::array<double, 1>& state, const Sym<double>& D,
                                     double d) const {
    ++count;
    return sand_.rate<double>(sigma, state, D, d);
  }
  [[nodiscard]] std::span<const StateVariable> states() const override { return sand_.states(); }
  [[nodiscard]] double density(std::span<const double> state) const override { return sand_.density(state); }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override { return sand_.assess(batch); }

  mutable std::int64_t count = 0;

private:
  GudehusBauer sand_;
};

/// Largest differences along a path, and its cost.
struct Errors {
  double angle = 0.0, stress = 0.0, void_ratio = 0.0; ///< [deg], relative, absolute
  std::int64_t evaluations = 0;
  MaterialReport report = {};

  void look(const SandPoint& at, const SandPoint& exact) {
    const auto degrees = [](const Sym<double>& s) {
      return std::asin((s.m[0] - s.m[1]) / -(s.m[0] + s.m[1])) * 180.0 / std::numbers::pi;
    };
    angle = std::max(angle, std::abs(degrees(at.stress) - degrees(exact.stress)));
    stress = std::max(stress, norm(at.stress - exact.stress) / norm(exact.stress));
    void_ratio = std::max(void_ratio, std::abs(at.state[0] - exact.state[0]));
  }
};

/// One increment of strain: from a point to the next.
using Method = std::function<SandPoint(const SandPoint&, const Sym<double>& strain)>;

class IntegratorErrors : public testing::Test {
protected:
  static constexpr double length = 0.051293; ///< −ln(1 − 0.05)
  static const std::vector<PathPlace>& path() {
    static const std::vector<PathPlace> fine = plane_strain_path(GudehusBauer(sand_values()), 52000);
    return fine;
  }
  static int increments(double size) { return static_cast<int>(std::lround(length / size)); }
  static const PathPlace& place(double size, int i) {
    return path()[static_cast<std::size_t>(std::lround(1e6 * size * i))];
  }
  /// Leads a point along the chords of the path. @param exact where the point should be after each increment
  template <class Exact>
  Errors follow(double size, const Method& method, const Exact& exact) {
    counted_.count = 0;
    Errors errors;
    SandPoint point = path().front().point;
    for (int i = 0; i < increments(size); ++i) {
      point = method(point, {{place(size, i + 1).lateral - place(size, i).lateral, -size, 0, 0, 0, 0}});
      errors.look(point, exact(i + 1));
    }
    errors.evaluations = counted_.count;
    return errors;
  }
  /// A number of equal steps for each increment. @param step from point, rate there, time and rate at any other point
  template <class Step>
  Method in_steps(int steps, const Step& step) const {
    return [this, steps, step](SandPoint point, const Sym<double>& D) {
      const auto rate_at = [&](const SandPoint& at) { return counted_.rate(at.stress, at.state, D, norm(D)); };
      for (int i = 0; i < steps; ++i) point = step(point, 1.0 / steps, rate_at);
      return point;
    };
  }
  /// As laws are integrated in a run. The counts remain in `bench`.
  static Method as_in_runs(LawBench& bench) {
    return [&bench](const SandPoint& point, const Sym<double>& D) {
      bench.put(0, point.stress, point.state[0], D);
      bench.integrate(1.0);
      return SandPoint{bench.stress_of(0), {bench.state[0][0]}};
    };
  }
  Errors follow_as_in_runs(double size, double tolerance, const std::vector<SandPoint>* chords = nullptr) {
    const auto law = std::make_shared<CountedSand>(tolerance);
    LawBench bench(law, 1);
    Errors errors = follow(size, as_in_runs(bench), [&](int i) {
      return chords ? (*chords)[static_cast<std::size_t>(i)] : place(size, i).point;
    });
    EXPECT_EQ(bench.report.failures, 0);
    errors.evaluations = law->count;
    errors.report = bench.report;
    return errors;
  }
  /// The solution along the chords themselves: 200 steps of order 3 for each.
  std::vector<SandPoint> along_chords(double size) {
    std::vector<SandPoint> points{path().front().point};
    const Method exact = in_steps(200, bogacki);
    follow(
        size,
        [&](const SandPoint& point, const Sym<double>& D) {
          points.push_back(exact(point, D));
          return points.back();
        },
        [&](int i) { return points[static_cast<std::size_t>(i)]; });
    return points;
  }

  static constexpr auto euler = [](const SandPoint& p, double t, const auto& rate_at) {
    return moved(p, rate_at(p), t);
  };
  static constexpr auto heuns = [](const SandPoint& p, double t, const auto& rate_at) {
    return heun(p, rate_at(p), t, rate_at).end;
  };
  static constexpr auto bogacki = [](const SandPoint& p, double t, const auto& rate_at) {
    return bogacki_shampine(p, rate_at(p), t, rate_at).end;
  };
  static constexpr auto embedded = [](const SandPoint& p, double t, const auto& rate_at) {
    return bogacki_shampine(p, rate_at(p), t, rate_at).embedded;
  };

  CountedSand counted_{1e-4};
};

void print(const char* method, double size, const Errors& e) {
  std::printf("| %-22s | %.0e | %.3e | %.3e | %.1e | %6d |\n", method, size, e.angle, e.stress, e.void_ratio,
              static_cast<int>(e.evaluations));
}

/// Row of the reference, whose columns are named differently.
struct Reference {
  double angle, stress;
};
Reference reference_row(const std::string& method, double size) {
  std::ifstream file(std::string(SOURCE_DIR) + "/tests/reference/integrator_errors.csv");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(method + ",")) continue;
    double increment = 0.0;
    Reference row{};
    std::sscanf(line.c_str() + method.size(), ",%lf,%lf,%lf", &increment, &row.angle, &row.stress);
    if (std::abs(increment / size - 1.0) < 1e-9) return row;
  }
  throw std::runtime_error("no row for " + method);
}

/// The chords of a path of increments are an error of second order by themselves, the smallest of any method.
TEST_F(IntegratorErrors, OfSingleStepsAreThoseOfTheReference) {
  std::printf("| %-22s | size  | angle deg | stress    | e       | rates  |\n", "method");
  const auto exact_at = [](double size) { return [size](int i) { return place(size, i).point; }; };
  for (const double size : {1e-6, 1e-5, 1e-4, 5e-4, 1e-3}) {
    const Errors errors = follow(size, in_steps(1, euler), exact_at(size));
    print("forward_euler", size, errors);
    const Reference known = reference_row("forward_euler", size);
    EXPECT_NEAR(errors.angle / known.angle, 1.0, 0.02);
    EXPECT_NEAR(errors.stress / known.stress, 1.0, 0.02);
  }
  for (const double size : {1e-5, 1e-4, 5e-4, 1e-3}) {
    const Errors errors = follow(size, in_steps(1, heuns), exact_at(size));
    print("heun", size, errors);
    const Reference known = reference_row("heun", size);
    EXPECT_NEAR(errors.angle / known.angle, 1.0, 0.05);
    EXPECT_NEAR(errors.stress / known.stress, 1.0, 0.05);
  }
  for (const double size : {1e-5, 1e-4, 5e-4, 1e-3}) {
    const Errors errors = follow(size, in_steps(1, bogacki), exact_at(size));
    print("bogacki_shampine", size, errors);
    const Reference known = reference_row("rk3", size);
    EXPECT_LT(errors.angle, 1.2 * known.angle) << "another method of order 3";
    EXPECT_LT(errors.stress, 2.0 * known.stress);
  }
  for (const double tolerance : {1e-4, 1e-6})
    for (const double size : {1e-5, 1e-4, 5e-4, 1e-3}) {
      const Errors errors = follow_as_in_runs(size, tolerance);
      print(tolerance == 1e-4 ? "adaptive_1e-4" : "adaptive_1e-6", size, errors);
      const Reference known = reference_row(tolerance == 1e-4 ? "heun_adaptive_1e-4" : "heun_adaptive_1e-6", size);
      if (size > 1e-5) { EXPECT_LT(errors.angle, 1.3 * known.angle + 1e-3); }
    }
}

/// Errors against the exact solution along the chords, where straight increments are no error.
TEST_F(IntegratorErrors, FallWithTheOrderOfTheMethod) {
  constexpr double size = 1e-3;
  const std::vector<SandPoint> exact = along_chords(size);
  std::printf("| method | steps of strain | stress | order | rates |\n");
  const auto order_of = [&](const char* name, const auto& step) {
    double before = 0.0, order = 0.0;
    for (const int steps : {1, 2, 4, 8, 16}) {
      const Errors errors =
          follow(size, in_steps(steps, step), [&](int i) { return exact[static_cast<std::size_t>(i)]; });
      order = std::log2(before / errors.stress);
      std::printf("| %-22s | %.2e | %.2e | %5.2f | %6d |\n", name, size / steps, errors.stress,
                  before > 0 ? order : 0.0, static_cast<int>(errors.evaluations));
      before = errors.stress;
    }
    return order;
  };
  EXPECT_NEAR(order_of("euler", euler), 1.0, 0.1);
  EXPECT_NEAR(order_of("heun", heuns), 2.0, 0.2);
  EXPECT_NEAR(order_of("bogacki_shampine", bogacki), 3.0, 0.2);
  EXPECT_NEAR(order_of("its embedded one", embedded), 2.0, 0.2);
}

TEST_F(IntegratorErrors, FollowTheTolerance) {
  constexpr double size = 1e-3;
  const std::vector<SandPoint> exact = along_chords(size);
  std::printf("| tolerance | stress | over tolerance | rates | sub-steps | rejected |\n");
  double before = 1.0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const Errors errors = follow_as_in_runs(size, tolerance, &exact);
    std::printf("| %.0e | %.2e | %.2f | %6d | %6d | %4d |\n", tolerance, errors.stress, errors.stress / tolerance,
                static_cast<int>(errors.evaluations), static_cast<int>(errors.report.substeps),
                static_cast<int>(errors.report.rejected_substeps));
    EXPECT_LT(errors.stress, 4.0 * tolerance);
    EXPECT_LT(errors.stress, before);
    before = errors.stress;
  }
}

} // namespace
} // namespace riedel::test
