/// Single calls of a UMAT, and what they tell of it.
#pragma once

#include "core/base/tensor.hpp"
#include "materials/umat.hpp"

namespace riedel {

/// Everything is done through the law, as a run does it, but for the stiffness.
class UmatProbe {
public:
  /// @param material values of the law's parameters   @param stress, strain 11, 22, 33, 12, 13, 23; engineering shear
  UmatProbe(const Values& material, const std::vector<double>& stress, const std::vector<double>& strain);

  [[nodiscard]] double wave_speed() const; ///< [m/s]
  /// The rest are relative to the change of stress over the increment. @throws RunError where the UMAT fails
  [[nodiscard]] double idle_change() const;                 ///< of a step without strain
  [[nodiscard]] double rotation_error() const;              ///< greatest over rotations of everything
  [[nodiscard]] std::vector<double> halving_errors() const; ///< of 1, 2, 4, … steps against twice the last
  [[nodiscard]] double stiffness_error() const;             ///< of DDSDDE, relative to its greatest entry
  [[nodiscard]] double copy_difference() const;             ///< between two copies of the library
  [[nodiscard]] double nanoseconds() const;                 ///< of a call

private:
  struct State {
    Sym<double> stress;
    std::vector<double> state;
  };
  [[nodiscard]] State start() const;
  [[nodiscard]] State advanced(const Umat& law, State from, const Sym<double>& strain, int steps) const;
  [[nodiscard]] State turned(State state, const Mat<3>& Q) const;
  [[nodiscard]] double change() const; ///< norm of the change of stress [Pa]

  Values material_;
  Umat law_;
  Sym<double> stress_, strain_;
};

} // namespace riedel
