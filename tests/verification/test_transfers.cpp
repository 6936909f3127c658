/// The transfers of velocities: what each one conserves, and how much motion it loses.
#include "support/schemes.hpp"
#include "verification/transfers.hpp"

#include <cstdio>
#include <numbers>

namespace riedel::test {
namespace {

template <int Dim>
Vec<Dim> momentum(const State<Dim>& state) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  const Points<Dim>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) sum += points.mass[0][p] * points.velocity_of(p);
  return sum;
}

/// Σ m_p (x_p × v_p + the angular momentum of B_p).
double angular_momentum(const State<2>& state, const VelocityTransfer<2>& transfer) {
  double sum = 0.0;
  const Points<2>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2> x = points.position_of(p), v = points.velocity_of(p);
    const Mat<2> B = transfer.velocity_moment(points, p);
    sum += points.mass[0][p] * (x[0] * v[1] - x[1] * v[0] + B(1, 0) - B(0, 1));
  }
  return sum;
}

TEST_P(TransferTest, KeepsLinearMomentumInEveryOrderOfTheStep) {
  for (const Transfer& chosen : {flip, pic, apic, tpic, xpic2, xpic5}) {
    if (!offers(chosen)) continue;
    for (const StepOrder<3>& order : orders_of_step<3>) {
      Simulation<3> simulation(model_with<3>(GetParam(), chosen, order.step), shaken_block<3>({2, 3, 2}));
      const Vec<3> start = momentum(simulation.state());
      const double mass = 12 * density * h * h * h;
      for (int i = 0; i < 20; ++i) simulation.step();
      EXPECT_LT((momentum(simulation.state()) - start).norm(), 1e-11 * mass * 1.0 /* m/s */)
          << chosen.label << ", " << order.name;
    }
  }
}

/// A disc that spins about its centre, four cells in radius, its centre off the lines of the grid.
State<2> spinning_disc(double omega, double stiffness) {
  State<2> state;
  state.grid = grid_of<2>({12, 12}, h, 4);
  const Vec<2> centre(6.0 * h, 6.0 * h);
  Body<2>& body = state.bodies.emplace_back();
  body.name = "disc";
  body.material =
      material("linear_elastic", {{"youngs_modulus", stiffness}, {"poissons_ratio", 0.3}, {"density", density}});
  fill<2>(body.points, {12, 12}, h, 2, density, 0, [&](const Vec<2>& x) { return (x - centre).norm() < 4.0 * h; });
  Points<2>& points = body.points;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2> r = points.position_of(p) - centre;
    points.velocity[0][p] = -omega * r[1];
    points.velocity[1][p] = omega * r[0];
    points.position[0][p] += 0.13 * h;
    points.position[1][p] += 0.21 * h;
  }
  return state;
}

/// Relative to those at the start.
struct Spin {
  double angular_momentum = 1.0, worst_error = 0.0, energy = 1.0;
};

Spin spin(const std::string& scheme, const Transfer& chosen, StepFunction<2> step, double stiffness, double turns) {
  const double omega = 20.0; // a tenth of the wave speed at the rim, where there is stiffness
  Model<2> model = model_with<2>(scheme, chosen, step);
  model.fixed_time_step = 2.5e-4;
  Simulation<2> simulation(std::move(model), spinning_disc(omega, stiffness));
  const double L = angular_momentum(simulation.state(), *simulation.model().transfer),
               E = simulation.energies().kinetic;
  Spin result;
  while (simulation.state().time < turns * 2.0 * std::numbers::pi / omega) {
    simulation.step();
    result.angular_momentum = angular_momentum(simulation.state(), *simulation.model().transfer) / L;
    result.worst_error = std::max(result.worst_error, std::abs(result.angular_momentum - 1.0));
  }
  result.energy = (simulation.energies().kinetic + simulation.energies().internal) / E;
  return result;
}

/// Forces have no moment, since Σ_i x_i ⊗ ∇N_ip = I, and the angular momentum Σ_i N_ip (x_i − x_p) × v_i is kept in
/// B_p.
TEST_P(TransferTest, ApicKeepsTheAngularMomentumOfADiscWithStressAndWithout) {
  if (!offers(apic)) GTEST_SKIP() << "apic is not offered";
  for (const StepOrder<2>& order : orders_of_step<2>) {
    const double stressed = spin(GetParam(), apic, order.step, 1e6, 2.0).worst_error;
    const double stress_free = spin(GetParam(), apic, order.step, 1e-3, 0.15).worst_error;
    std::printf("%-7s %-5s angular momentum lost by apic: %.1e with stress, %.1e without\n", GetParam().c_str(),
                order.name, stressed, stress_free);
    const bool moves_itself = traits(GetParam()).moves_points;
    EXPECT_LT(stressed, moves_itself ? 1e-4 : 1e-9);
    EXPECT_LT(stress_free, moves_itself ? 1e-4 : 1e-12);
  }
}

TEST_P(TransferTest, OnlyApicKeepsTheAngularMomentumAndNoTransferGainsEnergyInADisc) {
  if (!offers(apic)) GTEST_SKIP() << "on hats, slivers of mass tear the rim of the disc off";
  std::printf("%-7s angular momentum and energy after half a turn, over those at the start\n", GetParam().c_str());
  for (const StepOrder<2>& order : orders_of_step<2>) {
    std::map<std::string, Spin> after;
    for (const Transfer& chosen : {flip, blend, apic, tpic, xpic5, xpic2, pic}) {
      const Spin& s = after[chosen.label] = spin(GetParam(), chosen, order.step, 1e6, 0.5);
      std::printf("%-7s %-5s %-10s %10.6f %8.4f\n", GetParam().c_str(), order.name, chosen.label.c_str(),
                  s.angular_momentum, s.energy);
      EXPECT_LT(s.energy, 1.02) << chosen.label;
      if (!chosen.made<2>()->traits().keeps_angular_momentum) { EXPECT_GT(s.worst_error, 0.01) << chosen.label; }
    }
    EXPECT_GT(after["flip"].angular_momentum, 0.9);
    EXPECT_GT(after["tpic"].angular_momentum, 0.9);
    const double minimum = is_very_wide(GetParam()) ? 0.8 : 0.85; // wide functions smooth more
    for (const char* one : {"apic", "tpic"}) EXPECT_GT(after[one].energy, minimum);
    EXPECT_GT(after["xpic 5"].energy, after["xpic 2"].energy);
    EXPECT_GT(after["xpic 2"].energy, after["pic"].energy);
    EXPECT_LT(after["pic"].energy, 0.01);
  }
}

/// A bar of 16 cells, fixed at its left end, that vibrates in its first mode.
double energy_of_bar(const std::string& scheme, const Transfer& chosen, StepFunction<2> step, double periods) {
  const double length = 16 * h, c = std::sqrt(1e6 / density);
  State<2> state = elastic_state<2>({16, 1}, h, 2, 3, [](const Vec<2>&) { return true; },
                                    {{"youngs_modulus", 1e6}, {"poissons_ratio", 0.0}, {"density", density}});
  Points<2>& points = state.bodies[0].points;
  for (Index p = 0; p < points.size(); ++p)
    points.velocity[0][p] = 1e-3 * c * std::sin(0.5 * std::numbers::pi * points.position[0][p] / length);
  Model<2> model = model_with<2>(scheme, chosen, step);
  model.conditions.push_back(
      prescribe<2>({"left", {0, 0}, {3, state.grid.nodes[1] - 1}, 0, [](double) { return 0.0; }}));
  model.fixed_time_step = 0.2 * h / c;
  Simulation<2> simulation(std::move(model), std::move(state));
  const double start = simulation.energies().kinetic;
  double maximum = start;
  while (simulation.state().time < periods * 4.0 * length / c) {
    simulation.step();
    maximum = std::max(maximum, simulation.energies().kinetic + simulation.energies().internal);
  }
  EXPECT_LT(maximum, 1.01 * start) << chosen.label << " gains energy";
  return (simulation.energies().kinetic + simulation.energies().internal) / start;
}

TEST_P(TransferTest, TheStrongerTheFilterTheSoonerABarComesToRest) {
  std::printf("%-7s energy of a bar after ten periods, over that at the start\n", GetParam().c_str());
  for (const StepOrder<2>& order : orders_of_step<2>) {
    std::map<std::string, double> left;
    for (const Transfer& chosen : {flip, blend, apic, tpic, xpic5, xpic2, pic}) {
      if (!offers(chosen)) continue;
      left[chosen.label] = energy_of_bar(GetParam(), chosen, order.step, 10.0);
      std::printf("%-7s %-5s %-10s %8.4f\n", GetParam().c_str(), order.name, chosen.label.c_str(), left[chosen.label]);
    }
    const bool wide = is_wide(GetParam()) || !scheme<2>(GetParam())->gradients_follow_weights(); // they smooth more
    for (const char* one : {"flip", "apic", "tpic"})
      if (left.contains(one)) { EXPECT_GT(left[one], wide ? 0.96 : 0.99) << one << ", " << order.name; }
    EXPECT_LT(left["pic"], 0.01);
    EXPECT_LT(left["pic"], left["xpic 2"]);
    EXPECT_LT(left["xpic 2"], left["xpic 5"]);
    EXPECT_LT(left["xpic 5"], left["flip"]);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, TransferTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
