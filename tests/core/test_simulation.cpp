/// What a simulation refuses before its first step.
#include "support/problems.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

TEST(Simulation, RefusesPointsWithoutTheStateThatTheirLawDeclares) {
  const auto everywhere = [](const Vec<2>&) { return true; };
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, everywhere);
  state.bodies.front().material = material("gudehus_bauer");
  EXPECT_THROW(Simulation<2>(model_with<2>("gimp"), std::move(state)), InputError);
}

class StartOutsideTheGrid : public testing::TestWithParam<std::string> {};

TEST_P(StartOutsideTheGrid, IsRefusedWithThePointAndTheGrid) {
  const auto body_at = [](double x) {
    State<2> state = elastic_state<2>({4, 4}, 0.25, 1, 4, [](const Vec<2>&) { return true; });
    state.bodies.front().points.position[0][7] = x;
    return Simulation<2>(model_with<2>(GetParam()), std::move(state));
  };
  EXPECT_NO_THROW(body_at(1.25));
  for (const double x : {12.5, -1.025, 2.025}) // cells and corners that binary numbers hold
    EXPECT_THAT([&] { body_at(x); },
                testing::ThrowsMessage<InputError>(testing::AllOf(
                    testing::StartsWith("body 'body': point 7 at (" + exact_text(x) + ", 0.375) m"),
                    testing::HasSubstr("outside the grid, which reaches from (-1.0, -1.0) m to (2.0, 2.0) m"))));
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, StartOutsideTheGrid, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
