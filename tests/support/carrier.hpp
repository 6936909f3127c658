/// A law that does nothing, for tests of the solver.
#pragma once

#include "core/interface/material.hpp"

namespace riedel::test {

/// Keeps its stress and has a tensor and two scalars as state.
class Carrier final : public Material {
public:
  [[nodiscard]] std::span<const StateVariable> states() const override { return states_; }
  [[nodiscard]] double density(std::span<const double>) const override { return 1000.0; }
  void integrate(const MaterialBatch&, MaterialReport&) const override {}
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override { return {}; }

private:
  std::vector<StateVariable> states_{
      {"before", "-", "scalar", 1}, {"fabric", "-", "tensor", 6}, {"after", "-", "scalar", 1}};
};

} // namespace riedel::test
