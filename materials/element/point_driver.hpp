/// Drives one point of any law along a path of mixed control: each of six conditions prescribes the target of a
/// component of strain or stress, or of a combination of them.
#pragma once

#include "materials/element/material_point.hpp"

#include <functional>
#include <optional>

namespace riedel {

/// A scalar measure of the point that goes from its present value to a target: along a straight line, optionally with
/// one period of a sine superposed.
struct Condition {
  std::string name; ///< for messages
  std::function<double(const MaterialPoint&)> measure;
  double target;
  bool of_stress;                  ///< in Pa; otherwise a dimensionless number of the order of the strain
  double swing = 0.0, phase = 0.0; ///< amplitude of the sine, in the unit of the target; its phase at the start [rad]

  /// The value at a share of the leg. @param from value at the start of the leg
  [[nodiscard]] double course(double from, double share) const;
};

/// Six simultaneous conditions, or a prescribed motion.
struct LoadStep {
  std::array<Condition, 6> conditions;
  double duration = 1.0; ///< [s]; irrelevant for rate-independent laws
  /// The six free numbers of the velocity gradient: its upper triangle, so that 12 is a simple shear of the planes
  /// normal to 2 along 1, and vertical lines rotate; or its symmetric part, without spin; or none is free.
  enum class Motion { simple_shear, no_spin, given } motion = Motion::simple_shear;
  /// For a prescribed motion: deformation gradient from the start of the leg to its end, reached linearly.
  Mat<3> deformation = Mat<3>::Identity();
};

struct PointControl {
  /// Error allowed in one step: in the stress, relative to it, and in the deformation, relative to that of the step, or
  /// to a ten-thousandth of the leg's if that is larger [-]. Round-off of stress and deformation is not counted.
  double tolerance = 1e-5;
  double largest_share = 0.02; ///< of a leg in one step [-]
  /// Maximum change in one step, of the stress, relative, and of the strain, so that straight lines show the curve [-].
  double largest_change = 0.02, largest_strain = 0.01;
  double added_stiffness = 0.0; ///< of the other parts of stress conditions, in addition to the law's [Pa]
};

/// Each step is of second order: the velocity gradient is constant over it, and a modified Newton iteration finds the
/// one that meets the six conditions at its end; the law is called through Material::integrate only. If several
/// velocity gradients meet them, as at an edge of a yield surface, the smallest sufficient change is taken. A step is
/// taken in one and in two halves; their difference is the error that controls the step length. A third of it would
/// suffice for a law of second order; return mappings are of first order where the directions of stress rotate.
class PointDriver {
public:
  PointDriver(const Material& law, MaterialPoint start, const PointControl& control = {});

  /// Follows one leg to its end, or until `go_on`, called after each step, returns false.
  /// @return whether the end was reached
  /// @throws RunError if no deformation meets the conditions, or the law fails: says which, and where
  bool follow(const LoadStep& leg, const std::function<bool(const MaterialPoint&)>& go_on);

  /// The next leg begins another stage of the path, with time and steps counted from its start.
  void begin_stage() { riedel::begin_stage(point_); }

  [[nodiscard]] const MaterialPoint& point() const { return point_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const MaterialReport& report() const { return report_; } ///< of the steps that were kept

private:
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  struct Step { ///< a candidate
    MaterialPoint end;
    Vector increment; ///< the six free numbers of L Δt
    MaterialReport report;
    Vector residual;
    double size; ///< the largest residual over the allowed one
  };
  struct Halves { ///< a step taken in two halves
    Step first, second;
    double error, change; ///< over the allowed values: the step's error, its change of stress and strain
  };
  struct Task; ///< conditions of one step
  struct Allowed {
    double noise, stress, strain; ///< round-off of the stress; allowed residuals [Pa], [Pa], [-]
  };

  /// The first step of a leg: so short that its change of stress, large near zero stress only, is not limited.
  [[nodiscard]] double first_share() const { return 1e-3 * control_.largest_share; }
  [[nodiscard]] Allowed allowed() const;
  [[nodiscard]] Step moved(const Task& task, const Vector& increment, const Mat<3>& L) const;
  [[nodiscard]] Step attempt(const Task& task, const Vector& increment) const;
  void take_slopes(const Task& task, const Step& at);
  [[nodiscard]] Step corrected(const Task& task, const Step& step, bool slopes_are_new) const;
  std::optional<Step> solve_from(const Task& task, const Vector& guess);
  std::optional<Step> given_motion(const Task& task);
  [[nodiscard]] std::optional<Vector> scaled(const Task& task, const Vector& direction) const;
  std::optional<Step> solve(const Task& task, const Vector& guess);
  std::optional<Halves> step_and_halves(const LoadStep& leg, const std::array<double, 6>& from, double share,
                                        double length);
  [[nodiscard]] Halves compared(const Step& whole, const Step& first, const Step& second, double length,
                                const Allowed& allowed) const;
  void keep(const Halves& step, double length);
  [[nodiscard]] std::string lost(double share) const; ///< the message if the point cannot continue

  const Material& law_;
  PointControl control_;
  MaterialPoint point_;
  Vector rate_ = Vector::Zero();           ///< of the increment, per share of the leg
  Vector last_direction_ = Vector::Zero(); ///< in which the point moved at the end of the previous leg
  Matrix inverse_ = Matrix::Zero();        ///< inverse, or pseudo-inverse, of the residual's slopes times `scales_`
  Vector scales_ = Vector::Ones();
  bool has_slopes_ = false;
  std::string missed_;       ///< the condition with the largest residual in the last failure; empty: none
  std::string_view refused_; ///< why the law failed in it; empty: it did not fail
  std::int64_t steps_ = 0;
  MaterialReport report_;
};

} // namespace riedel
