/// Leads one point of any law along a path of mixed control: each of six conditions says what a component of strain or
/// of stress, or a combination of them, is to become.
#pragma once

#include "materials/element/material_point.hpp"

#include <functional>
#include <optional>

namespace riedel {

/// A scalar measure of the point that goes from its present value to a target: straight, or with one period of a sine
/// upon the straight line.
struct Condition {
  std::string name; ///< for messages
  std::function<double(const MaterialPoint&)> measure;
  double target;
  bool of_stress;                  ///< in Pa; otherwise a pure number of the order of the strain
  double swing = 0.0, phase = 0.0; ///< amplitude of the sine, as the target; its angle at the start [rad]

  /// The value at a share of the leg. @param from value at its start
  [[nodiscard]] double course(double from, double share) const;
};

/// Six conditions that hold at once, or a motion that is given whole.
struct LoadStep {
  std::array<Condition, 6> conditions;
  double duration = 1.0; ///< [s]; without meaning for laws that know no rate
  /// The six free numbers of the velocity gradient: its upper triangle, so that 12 is a simple shear of the planes
  /// normal to 2 along 1, and what stands vertical turns; or its symmetric part, with no spin; or none is free.
  enum class Motion { simple_shear, no_spin, given } motion = Motion::simple_shear;
  /// Of a given motion: deformation gradient from the start of the leg to its end, to which it goes straight.
  Mat<3> deformation = Mat<3>::Identity();
};

struct PointControl {
  /// Error allowed in one step: in the stress, relative to it, and in the deformation, relative to that of the step, or
  /// to a ten-thousandth of the leg's where that is more [-]. What round-off makes of stress and deformation is no
  /// error.
  double tolerance = 1e-5;
  double largest_share = 0.02; ///< of a leg that one step may take [-]
  /// Of the stress, relative, and of the strain in one step, so that straight lines show the curve [-].
  double largest_change = 0.02, largest_strain = 0.01;
  double added_stiffness = 0.0; ///< of what conditions of stress hold beside the law's stress [Pa]
};

/// Each step is of second order: the velocity gradient is constant over it, and a modified Newton iteration finds the
/// one that meets the six conditions at its end; the law is asked through Material::integrate alone. Where several
/// velocity gradients do, as at an edge of a yield surface, it takes the smallest change that helps. A step is taken
/// once whole and once in two halves; their difference is the error that sets the length of the steps. A third of it
/// would do for a law of second order; return mappings are of first order where the directions of stress turn.
class PointDriver {
public:
  PointDriver(const Material& law, MaterialPoint start, const PointControl& control = {});

  /// Follows one leg to its end, or until `go_on`, asked after each step, says no.
  /// @return whether the end was reached
  /// @throws RunError when no deformation meets the conditions, or the law fails: says which and how far the point has
  /// come
  bool follow(const LoadStep& leg, const std::function<bool(const MaterialPoint&)>& go_on);

  /// What follows is another stage of the path, whose time and steps count from its start.
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
    double size; ///< the greatest residual, over what is allowed
  };
  struct Halves { ///< a step taken in two halves
    Step first, second;
    double error, change; ///< over what is allowed: of the step's error, of its change of stress and strain
  };
  struct Task; ///< what one step has to meet
  struct Allowed {
    double noise, stress, strain; ///< round-off of the stress; what a residual may be [Pa], [Pa], [-]
  };

  /// The first step of a leg; one so short may change the stress as it likes, which is little but near zero stress.
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
  [[nodiscard]] std::string lost(double share) const; ///< the message of a point that can go no further

  const Material& law_;
  PointControl control_;
  MaterialPoint point_;
  Vector rate_ = Vector::Zero();           ///< of the increment, per share of the leg
  Vector last_direction_ = Vector::Zero(); ///< in which the point moved at the end of the leg before
  Matrix inverse_ = Matrix::Zero(); ///< of the slopes of the residual times `scales_`, or what comes nearest to it
  Vector scales_ = Vector::Ones();
  bool has_slopes_ = false;
  std::string missed_;       ///< the condition that the last failure missed most; empty: no step failed
  std::string_view refused_; ///< why the law failed in it; empty: it did not
  std::int64_t steps_ = 0;
  MaterialReport report_;
};

} // namespace riedel
