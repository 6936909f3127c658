#pragma once

#include "core/interface/material.hpp"
#include "materials/umat/library.hpp"
#include "materials/umat/point.hpp"

namespace riedel {

/// A user-defined law, written as a subroutine UMAT for Abaqus. See docs/howto/use_a_umat.md for its arguments.
class Umat final : public Material {
public:
  static constexpr std::string_view name = "umat";
  static Keys parameters();
  /// @throws InputError for inconsistent values, PluginError for a library that cannot be used
  explicit Umat(const Values& given);

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_.variables(); }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override;
  [[nodiscard]] std::vector<double> initial_state() const override { return states_.start(); }
  [[nodiscard]] bool follows_motion() const override { return true; }
  [[nodiscard]] double density(std::span<const double> state) const override;
  /// @throws RunError if the UMAT ends the program or crashes
  void integrate(const MaterialBatch& batch, MaterialReport& report) const override;
  /// From DDSDDE of a call without strain. @throws RunError likewise
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override;
  /// DDSDDE at the end of a step of point p, whose other results are discarded, by columns [Pa].
  /// @throws RunError if the UMAT does not return
  [[nodiscard]] std::array<double, 36> stiffness(const MaterialBatch& batch, Index p) const;
  /// Number of its state variables with a name in `state_names`; they come first.
  [[nodiscard]] std::size_t declared_states() const { return states_.declared(); }

private:
  [[nodiscard]] UmatPoint point_of(const MaterialBatch& batch, Index p) const;
  [[nodiscard]] std::array<double, 36> stiffness(const UmatLibrary::Lease& umat, const MaterialBatch& batch,
                                                 Index p) const;
  /// @throws RunError if it ended the program or crashed
  UmatEnd call(UmatPoint& point, const UmatLibrary::Lease& umat) const;
  std::string_view advance(UmatPoint& point, const UmatLibrary::Lease& umat, MaterialReport& report) const;
  std::string_view advance_in_parts(UmatPoint& point, double share, const UmatLibrary::Lease& umat,
                                    MaterialReport& report) const;

  std::unique_ptr<UmatLibrary> library_; ///< null: no library was named, and every step fails
  std::string cmname_;
  std::vector<double> parameters_;
  bool takes_average_;
  double stress_unit_;                      ///< [Pa]
  double density_, grain_density_, length_; ///< [kg/m³], [kg/m³], [m]
  UmatStates states_;
};

} // namespace riedel
