/// What every transfer of velocities must satisfy in a motion: momenta, translations, energy.
#pragma once

#include "transfers/blocks.hpp"

#include <gtest/gtest.h>

namespace riedel::test {

/// Σ m_p v_p and, as the entries of a skew tensor, Σ m_p (x_p × v_p + the angular momentum of B_p).
template <int Dim>
struct Momenta {
  Vec<Dim> linear = Vec<Dim>::Zero();
  Mat<Dim> angular = Mat<Dim>::Zero();
};

template <int Dim>
Momenta<Dim> momenta_of(const Simulation<Dim>& simulation) {
  const Points<Dim>& points = simulation.state().bodies[0].points;
  Momenta<Dim> sum;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> x = points.position_of(p), v = points.velocity_of(p);
    const Mat<Dim> turning = v * x.transpose() + simulation.model().transfer->velocity_moment(points, p);
    sum.linear += points.mass[0][p] * v;
    sum.angular += points.mass[0][p] * (turning - turning.transpose());
  }
  return sum;
}

/// With stress, in the orders that the transfer supports.
template <int Dim>
void expect_momenta_to_stay(const TransferPointer<Dim>& chosen, const std::string& scheme_name) {
  const TransferTraits traits = chosen->traits();
  for (const StepOrder<Dim>& order : orders_of_step<Dim>) {
    if (!traits.goes_with(order.name)) continue;
    SCOPED_TRACE(scheme_name + ", " + order.name);
    State<Dim> state = scattered_block<Dim>(some_cells<Dim>(3), 1e5);
    shake(state.bodies[0].points);
    Model<Dim> model = model_of<Dim>(scheme_name, chosen, order.step);
    model.cfl = 0.2;
    Simulation<Dim> simulation(std::move(model), std::move(state));
    const Momenta<Dim> start = momenta_of(simulation);
    for (int i = 0; i < 20; ++i) simulation.step();
    const Momenta<Dim> now = momenta_of(simulation);
    double mass = 0.0;
    const Points<Dim>& points = simulation.state().bodies[0].points;
    for (Index p = 0; p < points.size(); ++p) mass += points.mass[0][p];
    EXPECT_LT((now.linear - start.linear).norm(), 1e-10 * mass);
    const double turned = (now.angular - start.angular).norm();
    if (traits.keeps_angular_momentum)
      EXPECT_LT(turned, 1e-10 * mass * 10 * cell);
    else
      EXPECT_GT(turned, 1e-7 * mass * 10 * cell) << "it keeps the angular momentum and does not say so";
  }
}

/// A body in uniform motion across cells: velocities, shape and stress do not change.
template <int Dim>
void expect_a_translation_to_stay(const TransferPointer<Dim>& chosen, const std::string& scheme_name) {
  const Vec<Dim> v = Vec<3>(3.0, -2.0, 1.0).head<Dim>();
  for (const StepOrder<Dim>& order : orders_of_step<Dim>) {
    if (!chosen->traits().goes_with(order.name)) continue;
    SCOPED_TRACE(scheme_name + ", " + order.name);
    State<Dim> state = scattered_block<Dim>(some_cells<Dim>(3), 1e5);
    std::vector<Vec<Dim>> start;
    Points<Dim>& at_start = state.bodies[0].points;
    for (Index p = 0; p < at_start.size(); ++p) {
      start.push_back(at_start.position_of(p));
      for (int a = 0; a < Dim; ++a) at_start.velocity[a][p] = v[a];
    }
    Model<Dim> model = model_of<Dim>(scheme_name, chosen, order.step);
    model.fixed_time_step = 0.1 * cell / v.norm();
    Simulation<Dim> simulation(std::move(model), std::move(state));
    for (int i = 0; i < 15; ++i) simulation.step();
    const Points<Dim>& points = simulation.state().bodies[0].points;
    for (Index p = 0; p < points.size(); ++p) {
      const Vec<Dim> place = start[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])];
      EXPECT_LT((points.velocity_of(p) - v).norm(), 1e-9 * v.norm());
      EXPECT_LT((points.position_of(p) - place - simulation.state().time * v).norm(), 1e-9 * cell);
      EXPECT_LT((points.deformation_gradient_of(p) - Mat<Dim>::Identity()).norm(), 1e-9);
    }
  }
}

/// Points that separate without forces, each with its own velocity.
template <int Dim>
void expect_no_energy_to_be_gained(const TransferPointer<Dim>& chosen, const std::string& scheme_name) {
  for (const StepOrder<Dim>& order : orders_of_step<Dim>) {
    if (!chosen->traits().goes_with(order.name)) continue;
    SCOPED_TRACE(scheme_name + ", " + order.name);
    State<Dim> state = scattered_block<Dim>(some_cells<Dim>(4), 1e-6);
    shake(state.bodies[0].points);
    Model<Dim> model = model_of<Dim>(scheme_name, chosen, order.step);
    model.fixed_time_step = 0.02 * cell;
    Simulation<Dim> simulation(std::move(model), std::move(state));
    const double start = simulation.energies().kinetic;
    for (int i = 0; i < 20; ++i) {
      simulation.step();
      ASSERT_LT(simulation.energies().kinetic, (1.0 + 1e-9) * start) << "after step " << i + 1;
    }
  }
}

} // namespace riedel::test
