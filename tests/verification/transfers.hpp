/// Problems for tests of the transfers of velocities.
#pragma once

#include "core/step/orders.hpp"
#include "support/problems.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace riedel::test {
constexpr double density = 1000.0, h = 0.05;
const std::map<std::string, Value> soft{{"youngs_modulus", 1e6}, {"poissons_ratio", 0.3}, {"density", density}};

/// A transfer with its own parameters.
struct Transfer {
  std::string label, name;
  std::map<std::string, Value> with = {};

  template <int Dim>
  [[nodiscard]] std::shared_ptr<const VelocityTransfer<Dim>> made() const {
    return transfer<Dim>(name, with);
  }
};
inline const Transfer flip{"flip", "flip", {{"flip", 1.0}}}, pic{"pic", "flip", {{"flip", 0.0}}},
    blend{"flip 0.98", "flip", {{"flip", 0.98}}}, apic{"apic", "apic"}, tpic{"tpic", "tpic"}, xpic2{"xpic 2", "xpic"},
    xpic5{"xpic 5", "xpic", {{"xpic_order", 5}}};

template <int Dim>
Model<Dim> model_with(const std::string& scheme, const Transfer& chosen, StepFunction<Dim> step) {
  Model<Dim> model = model_with<Dim>(scheme);
  model.step = step;
  model.transfer = chosen.made<Dim>();
  return model;
}

/// Two or more along every axis.
template <int Dim>
Counts<Dim> few_cells() {
  Counts<Dim> cells;
  cells.fill(2);
  cells[0] = Dim == 2 ? 4 : 2;
  return cells;
}

/// Points anywhere near a lattice, each with its own velocity.
template <int Dim>
State<Dim> shaken_block(Counts<Dim> cells) {
  State<Dim> state = elastic_state<Dim>(
      cells, h, 2, 5, [](const Vec<Dim>&) { return true; }, soft);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  Points<Dim>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p)
    for (int a = 0; a < Dim; ++a) {
      points.position[a][p] += 0.1 * h * between(random);
      points.velocity[a][p] = between(random);
    }
  return state;
}

/// A suite over all schemes.
class TransferTest : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); } // too small to share
  static bool offers(const Transfer& chosen) { return goes_with(chosen.name, GetParam()); }
};

} // namespace riedel::test
