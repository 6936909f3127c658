/// Leads one point of any law along a path of mixed control: each of six conditions says what a component of strain or
/// of stress, or a combination of them, is to become.
#pragma once

#include "materials/law_point.hpp"

#include <functional>
#include <optional>

namespace riedel {

/// A scalar measure of the point that goes straight from its present value to a target.
struct Condition {
  std::string name; ///< for messages
  std::function<double(const LawPoint&)> measure;
  double target;
  bool of_stress; ///< in Pa; otherwise a pure number of the order of the strain
};

/// Six conditions that hold at once.
struct Leg {
  std::array<Condition, 6> conditions;
  double duration = 1.0; ///< [s]; without meaning for laws that know no rate
  /// The six free numbers of the velocity gradient: its upper triangle, so that 12 is a simple shear of the planes
  /// normal to 2 along 1, and what stands vertical turns; or its symmetric part, with no spin.
  enum class Motion { simple_shear, no_spin } motion = Motion::simple_shear;
};

struct PointControl {
  /// Error allowed in one step: in the stress, relative to it, and in the deformation, relative to that of the step
  /// [-].
  double tolerance = 1e-5;
  double largest_share = 0.02; ///< of a leg that one step may take [-]
  /// Of the stress, relative, and of the strain in one step, so that straight lines show the curve [-].
  double largest_change = 0.02, largest_strain = 0.01;
};

/// Each step is of second order: the velocity gradient is constant over it, and a modified Newton iteration finds the
/// one that meets the six conditions at its end; the law is asked through Material::integrate alone. A step is taken
/// once whole and once in two halves; their difference, over three, is the error that sets the length of the steps.
class PointDriver {
public:
  PointDriver(const Material& law, LawPoint start, const PointControl& control = {});

  /// Follows one leg to its end, or until `go_on`, asked after each step, says no.
  /// @return whether the end was reached
  /// @throws RunError when no deformation meets the conditions: names the condition and how far the point has come
  bool follow(const Leg& leg, const std::function<bool(const LawPoint&)>& go_on);

  [[nodiscard]] const LawPoint& point() const { return point_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const MaterialReport& report() const { return report_; } ///< of the steps that were kept

private:
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  struct Step { ///< a candidate
    LawPoint end;
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

  /// The first step of a leg; one so short may change the stress as it likes, which is little but near zero stress.
  [[nodiscard]] double first_share() const { return 1e-3 * control_.largest_share; }
  [[nodiscard]] Step attempt(const Task& task, const Vector& increment) const;
  [[nodiscard]] Matrix slopes(const Task& task, const Step& at) const;
  [[nodiscard]] Step corrected(const Task& task, const Step& step, bool slopes_are_new) const;
  std::optional<Step> solve_from(const Task& task, const Vector& guess);
  [[nodiscard]] std::optional<Vector> scaled(const Task& task, const Vector& direction) const;
  std::optional<Step> solve(const Task& task, const Vector& guess);
  std::optional<Halves> step_and_halves(const Leg& leg, const std::array<double, 6>& from, double share, double length);
  void keep(const Halves& step, double length);
  [[nodiscard]] std::string lost(double share) const; ///< the message of a point that can go no further

  const Material& law_;
  PointControl control_;
  LawPoint point_;
  Vector rate_ = Vector::Zero();           ///< of the increment, per share of the leg
  Vector last_direction_ = Vector::Zero(); ///< in which the point moved at the end of the leg before
  Matrix slopes_ = Matrix::Zero();
  bool has_slopes_ = false;
  std::string missed_; ///< the condition that the last failure missed most
  std::int64_t steps_ = 0;
  MaterialReport report_;
};

} // namespace riedel
