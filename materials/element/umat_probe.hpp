/// Single calls of a UMAT, and what they tell of it.
#pragma once

#include "materials/element/material_point.hpp"
#include "materials/umat.hpp"

#include <optional>

namespace riedel {

/// By how much something is off, relative to its change over the increment; or over the size that it has anyway, if
/// that hardly changes.
struct Disagreement {
  std::string of; ///< "the stress", "STATEV h"
  double error = 0.0;
  bool declared = true; ///< what it is was said, so that it can be judged
};

/// Everything is done through the law, as the point driver does it, but for the stiffness. A step takes a second.
/// All throw RunError where the UMAT fails, with the name of the probe.
class UmatProbe {
public:
  /// @param material values of the law's parameters   @param stress, strain 11, 22, 33, 12, 13, 23; engineering shear
  UmatProbe(const Values& material, const std::vector<double>& stress, const std::vector<double>& strain);

  void one_step() const;                    ///< throws where it does nothing, too
  [[nodiscard]] double wave_speed() const;  ///< [m/s]
  [[nodiscard]] double idle_change() const; ///< of the stress in a step without strain, relative
  /// A body that turns, and then is strained, against one that is strained where it stands: the greatest over
  /// rotations, of the stress and of each state variable.
  [[nodiscard]] std::vector<Disagreement> rotation_errors() const;
  [[nodiscard]] std::vector<double> halving_errors() const;    ///< of 1, 2, 4, … steps against twice the last
  [[nodiscard]] double stiffness_error() const;                ///< of DDSDDE, relative to its greatest entry
  [[nodiscard]] std::optional<double> copy_difference() const; ///< between two copies; empty: none can be made
  [[nodiscard]] double nanoseconds() const;                    ///< of a call

private:
  [[nodiscard]] MaterialPoint start() const;
  [[nodiscard]] MaterialPoint strained(const Umat& law, MaterialPoint from, const Sym<double>& strain, int steps,
                                       const char* probe) const;
  [[nodiscard]] double change() const; ///< norm of the change of stress [Pa]
  void compare(const MaterialPoint& there, const MaterialPoint& expected, std::vector<Disagreement>& worst) const;

  Values material_;
  Umat law_;
  Sym<double> stress_, strain_;
};

} // namespace riedel
