#pragma once

#include "core/interface/material.hpp"
#include "materials/umat_library.hpp"

namespace riedel {

/// A law that somebody has written as a subroutine UMAT for Abaqus. docs/howto/use_a_umat.md says what it is given and
/// what is asked of it.
class Umat final : public Material {
public:
  static constexpr std::string_view name = "umat";
  static Keys parameters();
  /// @throws InputError for values that do not fit together, PluginError for a library that cannot be used
  explicit Umat(const Values& given);

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override;
  [[nodiscard]] std::vector<double> initial_state() const override { return initial_; }
  [[nodiscard]] bool follows_motion() const override { return true; }
  [[nodiscard]] double density(std::span<const double> state) const override;
  void integrate(const MaterialBatch& batch, MaterialReport& report) const override;
  [[nodiscard]] Survey survey(const MaterialBatch& batch) const override;
  /// DDSDDE at the end of a step of point p, whose other results are dropped, by columns [Pa].
  [[nodiscard]] std::array<double, 36> stiffness(const MaterialBatch& batch, Index p) const;

private:
  struct Point;
  void add_states(const Values& given);
  [[nodiscard]] Point point_of(const MaterialBatch& batch, Index p) const;
  void give_back(const Point& point, const MaterialBatch& batch, Index p) const;
  [[nodiscard]] std::array<double, 36> stiffness(const UmatLibrary::Lease& umat, const MaterialBatch& batch,
                                                 Index p) const;
  std::string_view advance(Point& point, const UmatLibrary::Lease& umat, MaterialReport& report) const;

  std::unique_ptr<UmatLibrary> library_; ///< null: none was named; every step fails
  std::string cmname_;
  std::vector<double> parameters_;
  bool takes_average_;
  double density_, grain_density_, length_; ///< [kg/m³], [kg/m³], [m]
  std::vector<StateVariable> states_;       ///< the UMAT's, then the total strain
  std::vector<double> shear_factors_;       ///< by the UMAT's state numbers: from Mandel's components to its own
  std::vector<double> initial_;
  int void_ratio_ = -1; ///< column
};

} // namespace riedel
