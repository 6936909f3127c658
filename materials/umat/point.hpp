/// Converts one point between the columns of a batch and the arguments of a UMAT.
#pragma once

#include "materials/umat/library.hpp"
#include "materials/umat/states.hpp"

#include <Eigen/Geometry>

namespace riedel {

struct UmatPoint {
  UmatCall call;
  std::size_t states; ///< NSTATV
  std::array<double, UmatStates::maximum> state;

  explicit UmatPoint(std::size_t count) : states(count) {}
  UmatPoint(const UmatPoint& other) : call(other.call), states(other.states) { copy_state(other); }
  UmatPoint& operator=(const UmatPoint& other) {
    call = other.call;
    states = other.states;
    copy_state(other);
    return *this;
  }

private:
  void copy_state(const UmatPoint& other) { std::copy_n(other.state.begin(), states, state.begin()); }
};

/// The UMAT's input for a step, in its own units: all except CMNAME, PROPS and CELENT.
/// @param stress_unit of the UMAT [Pa]
UmatPoint umat_point(const MaterialBatch& batch, Index p, const UmatStates& states, double stress_unit);
/// Writes the UMAT's results into the columns.
void give_back(const UmatPoint& point, const MaterialBatch& batch, Index p, const UmatStates& states,
               double stress_unit);

/// A step that is taken in parts: each is a complete step, with its share of the strain, its own F before and after it
/// and its own rotation; in the end everything has rotated as in the whole step.
class UmatParts {
public:
  /// @param whole the point at the start of the step, already rotated to its end
  UmatParts(const UmatPoint& whole, const UmatStates& states);

  /// The point at the start of the next part. @param share of the step
  [[nodiscard]] UmatPoint next(double share) const;
  /// Takes over the results of the part.
  void keep(const UmatPoint& answer, double share);
  [[nodiscard]] const UmatPoint& point() const { return now_; }
  [[nodiscard]] double done() const { return done_; } ///< share of the step

private:
  void turn(UmatPoint& point, const Eigen::Matrix3d& Q) const;
  [[nodiscard]] Eigen::Matrix3d turned(double share) const; ///< Q of a share of the step

  const UmatStates& states_;
  UmatPoint whole_, now_;
  Eigen::AngleAxisd rotation_;
  double done_ = 0.0;
};

} // namespace riedel
