/// A law whose strength is lower, or higher, at some of the points.
#pragma once

#include "core/interface/material.hpp"

namespace riedel {

/// The same law twice, with the parameters of the specimen and with those of its weak zone. Its last state variable
/// marks the points of the zone, in any order; everything else is the law's.
class WeakZoneLaw final : public Material {
public:
  static constexpr std::string_view zone = "weak_zone"; ///< 1 in the zone, 0 elsewhere

  /// Both must declare the same state variables.
  WeakZoneLaw(std::unique_ptr<Material> sound, std::unique_ptr<Material> weak);

  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return sound_->nonlocal_variables(); }
  [[nodiscard]] std::vector<double> initial_state() const override;
  [[nodiscard]] bool follows_motion() const override { return sound_->follows_motion(); }
  [[nodiscard]] double density(std::span<const double> state) const override;
  void integrate(const MaterialBatch& batch, MaterialReport& report) const override;
  [[nodiscard]] MaterialLimits assess(const MaterialBatch& batch) const override;

private:
  [[nodiscard]] const Material& at(double flag) const { return flag > 0.5 ? *weak_ : *sound_; }
  template <class Visit>
  void for_each_run(const MaterialBatch& batch, const Visit& visit) const;

  std::unique_ptr<Material> sound_, weak_;
  std::vector<StateVariable> states_;
};

} // namespace riedel
