/// The state variables of a UMAT: names, kinds and units of the numbers in STATEV.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

class UmatStates {
public:
  static constexpr std::size_t maximum = 512; ///< numbers in STATEV

  /// @param names "void_ratio, h:strain, back:stress": one number each, or six; the remaining ones are numbered
  /// @param start STATEV at the start, in the UMAT's units; empty: zeros   @param stress_unit of the UMAT [Pa]
  /// @throws InputError for names that cannot be parsed and numbers that do not match them
  UmatStates(const std::string& names, const std::vector<double>& start, double stress_unit);

  /// STATEV, then the total strain, which rotates with the material like declared tensors.
  [[nodiscard]] std::span<const StateVariable> variables() const { return variables_; }
  [[nodiscard]] const std::vector<double>& start() const { return start_; } ///< in Mandel's components and SI units
  [[nodiscard]] std::size_t size() const { return factors_.size(); }        ///< NSTATV
  [[nodiscard]] std::size_t declared() const { return declared_; }          ///< number of variables with a name
  [[nodiscard]] int void_ratio() const { return void_ratio_; }              ///< its column, or −1
  /// Conversion factor of a number: the UMAT's value over that in a column.
  [[nodiscard]] double factor(std::size_t number) const { return factors_[number]; }
  /// Rotates the declared tensors in STATEV. @param Q by columns
  void rotate(double* statev, const double* Q) const;

private:
  /// Where the six numbers of a tensor begin, and Abaqus' number for stresses, 1, or strains, 2.
  struct Tensor {
    std::size_t first;
    int kind;
  };
  void declare(const std::string& word, double stress_unit);

  std::vector<StateVariable> variables_;
  std::vector<double> factors_, start_;
  std::vector<Tensor> tensors_;
  std::size_t declared_ = 0;
  int void_ratio_ = -1;
};

/// Factor of a component from Mandel's to Abaqus' notation: stresses unchanged, strains with engineering shear.
constexpr double umat_stress_shear = 1.0 / std::numbers::sqrt2, umat_strain_shear = std::numbers::sqrt2;

} // namespace riedel
