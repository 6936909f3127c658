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

/// Why a block of elastic points is refused once `spoil` has changed it.
template <class Spoil>
std::string refusal(const Spoil& spoil) {
  State<2> state = elastic_state<2>({4, 4}, 0.01, 1, 3, [](const Vec<2>&) { return true; });
  Model<2> model = model_with<2>("gimp");
  spoil(state, model);
  try {
    const Simulation<2> simulation(std::move(model), std::move(state));
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(Simulation, RefusesAPointWithoutMassVolumeOrExtentAndNamesIt) {
  EXPECT_EQ(refusal([](State<2>&, Model<2>&) {}), "no error");
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies[0].points.mass[0][7] = 0.0; }),
            "body 'body', point 7: its mass is 0.0 kg/m; allowed: more than 0");
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies[0].points.volume[0][3] = -2.0; }),
            "body 'body', point 3: its volume is -2.0 m2; allowed: more than 0");
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies[0].points.initial_volume[0][3] = 0.0; }),
            "body 'body', point 3: its initial volume is 0.0 m2; allowed: more than 0");
  EXPECT_THAT(refusal([](State<2>& s, Model<2>&) { s.bodies[0].points.half_size[1][15] = std::nan(""); }),
              testing::HasSubstr("body 'body', point 15: its half size is "));
}

TEST(Simulation, RefusesWhatCannotBegin) {
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies.clear(); }), "a simulation needs a body");
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies[0].points.resize(0, 0); }), "body 'body' has no points");
  EXPECT_EQ(refusal([](State<2>& s, Model<2>&) { s.bodies[0].material = nullptr; }), "body 'body' has no material");
  EXPECT_EQ(refusal([](State<2>&, Model<2>& m) { m.scheme = nullptr; }), "the model has no interpolation scheme");
  EXPECT_THAT(refusal([](State<2>&, Model<2>& m) { m.step = nullptr; }), testing::StartsWith("the model has no step"));
  EXPECT_THAT(refusal([](State<2>& s, Model<2>&) { s.grid.cell[1] = 0.0; }),
              testing::HasSubstr("along axis 1, 0.0 m apart"));
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
