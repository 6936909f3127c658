/// The point driver as a driver of element tests.
#include "apps/element_drivers.hpp"
#include "apps/element_path.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

/// Decides which points become rows: straight lines between them show the curve.
class Rows {
public:
  Rows(const Material& law, double void_ratio, double every, Friction friction, const ElementWatch& watch,
       std::vector<ElementRow>& rows)
      : column_(state_column(law.states(), "void_ratio")),
        void_ratio_(void_ratio),
        every_(every),
        friction_(friction),
        watch_(watch),
        rows_(rows) {}

  void look(const LawPoint& point) {
    last_ = row_of(point);
    point_ = point;
    written_ = false;
    if (rows_.empty() || !near(rows_.back(), last_)) write();
  }
  /// The last one looked at becomes a row, wherever it lies.
  void write() {
    if (written_) return;
    rows_.push_back(last_);
    watch_.at_row(last_, point_);
    written_ = true;
  }

private:
  [[nodiscard]] ElementRow row_of(const LawPoint& point) const {
    const double e = column_ >= 0 ? point.state[static_cast<std::size_t>(column_)]
                                  : (1.0 + void_ratio_) * point.F.determinant() - 1.0; // a law that carries none
    return element_row(point, e, friction_);
  }
  [[nodiscard]] bool near(const ElementRow& a, const ElementRow& b) const {
    constexpr double angle = 0.1, share = 0.005; // [deg], of the stress
    double strain = std::abs(a.gamma - b.gamma), change = std::abs(a.tau - b.tau), size = std::abs(b.tau);
    for (std::size_t c = 0; c < 3; ++c) {
      strain = std::max(strain, std::abs(a.eps[c] - b.eps[c]));
      change = std::max(change, std::abs(a.sigma[c] - b.sigma[c]));
      size = std::max(size, std::abs(b.sigma[c]));
    }
    return strain < every_ && change < share * size && std::abs(a.phi_mob - b.phi_mob) < angle;
  }

  int column_;
  double void_ratio_, every_;
  Friction friction_;
  const ElementWatch& watch_;
  std::vector<ElementRow>& rows_;
  ElementRow last_;
  LawPoint point_;
  bool written_ = false;
};

LawPoint start_of(const Material& law, const Sym<double>& stress, const Values& values) {
  LawPoint start{.stress = stress,
                 .state = std::vector<double>(static_cast<std::size_t>(state_components(law.states())))};
  const int e = state_column(law.states(), "void_ratio");
  if (e >= 0) start.state[static_cast<std::size_t>(e)] = values.number("specimen.void_ratio");
  if (survey(law, start).out_of_bounds > 0)
    throw InputError("the law does not admit the state at the start: void ratio " +
                     exact_text(values.number("specimen.void_ratio")) + ", mean pressure " +
                     exact_text(-trace(stress) / 3.0) + " Pa");
  return start;
}

/// @return whether the test goes on
bool follow_stage(PointDriver& driver, const PathStage& stage, const ElementWatch& watch, Rows& rows,
                  bool& interrupted) {
  for (std::int64_t round = 0; round < stage.repeat; ++round)
    for (const PathLeg& leg : stage.legs) {
      bool ended = false;
      driver.follow(leg_from(leg, driver.point()), [&](const LawPoint& point) {
        rows.look(point);
        interrupted = watch.stop();
        ended = stage.until && stage.until->reached(point);
        return !interrupted && !ended;
      });
      rows.write();
      if (interrupted) return false;
      if (ended) return true;
    }
  return true;
}

} // namespace

ElementCurve run_point_driver(const Values& values, const Catalogue& catalogue, const ElementWatch& watch) {
  const ElementPath path = element_path(values);
  const auto law = catalogue.materials.find(values.text("material.model")).make(values.section("material"));
  const LawPoint start = start_of(*law, path.stress, values);
  ElementCurve curve{.test = values.text("test"), .rows = {}, .failure = {}, .report = {}};
  const double every = values.number("output.every_strain");
  PointDriver driver(*law, start, {.tolerance = values.number("driver.tolerance"), .largest_strain = every});
  Rows rows(*law, values.number("specimen.void_ratio"), every, path.friction, watch, curve.rows);
  rows.look(start);
  for (const PathStage& stage : path.stages) {
    try {
      if (!follow_stage(driver, stage, watch, rows, curve.interrupted)) break;
    } catch (const RunError& error) {
      rows.write();
      curve.failure = stage.name + ": " + error.what();
      break;
    }
  }
  curve.steps = driver.steps();
  curve.report = driver.report();
  return curve;
}

} // namespace riedel
