/// Single calls of a UMAT, and the checks based on them.
#pragma once

#include "materials/element/material_point.hpp"
#include "materials/umat.hpp"

#include <optional>

namespace riedel {

/// Size of a deviation, relative to the change over the increment; or to the size itself, if that hardly changes.
struct Disagreement {
  std::string of; ///< "the stress", "STATEV h"
  double error = 0.0;
  bool declared = true; ///< its kind was declared, so that it can be judged
};

/// All calls go through the law, as in the point driver, except for the stiffness. A step takes a second. All throw
/// RunError if the UMAT fails, with the name of the probe.
class UmatProbe {
public:
  /// @param material values of the law's parameters   @param stress, strain 11, 22, 33, 12, 13, 23; engineering shear
  UmatProbe(const Values& material, const std::vector<double>& stress, const std::vector<double>& strain);

  void one_step() const;                    ///< also throws if it does nothing
  [[nodiscard]] double wave_speed() const;  ///< [m/s]
  [[nodiscard]] double idle_change() const; ///< of the stress in a step without strain, relative
  /// A body that rotates and is then strained, compared with one that is strained without rotation: maximum over
  /// rotations, of the stress and of each state variable.
  [[nodiscard]] std::vector<Disagreement> rotation_errors() const;
  [[nodiscard]] std::vector<double> halving_errors() const; ///< of 1, 2, 4, … steps relative to twice the last number
  [[nodiscard]] double stiffness_error() const;             ///< of DDSDDE, relative to its largest entry
  [[nodiscard]] std::optional<double> copy_difference() const; ///< between two copies; empty: no copy can be made
  [[nodiscard]] double nanoseconds() const;                    ///< per call

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
