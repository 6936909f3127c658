/// What a simulation refuses before its first step.
#include "support/problems.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

TEST(Simulation, RefusesPointsWithoutTheStateThatTheirLawDeclares) {
  const auto everywhere = [](const Vec<2>&) { return true; };
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, everywhere);
  state.bodies.front().material = material("gudehus_bauer");
  EXPECT_THROW(Simulation<2>(model_with<2>("gimp"), std::move(state)), InputError);
}

} // namespace
} // namespace riedel::test
