/// What every transfer of velocities must satisfy, registered or from a plug-in: in a motion, on any number of threads,
/// and when points are sorted.
#pragma once

#include "core/state/cell_order.hpp"
#include "support/fields_by_id.hpp"
#include "transfers/contract_motion.hpp"

#include <cstring>
#include <omp.h>

namespace riedel::test {

template <int Dim>
void expect_the_same_bits_on_any_threads(const TransferPointer<Dim>& chosen, const std::string& scheme_name) {
  for (const StepOrder<Dim>& order : orders_of_step<Dim>) {
    if (!chosen->traits().goes_with(order.name)) continue;
    std::vector<double> alone;
    for (const int threads : {1, 2, 4}) {
      omp_set_num_threads(threads);
      Counts<Dim> cells = some_cells<Dim>(2);
      cells[Dim - 1] = 20; // enough slabs for several threads
      State<Dim> state = scattered_block<Dim>(cells, 1e5);
      shake(state.bodies[0].points);
      Model<Dim> model = model_of<Dim>(scheme_name, chosen, order.step);
      model.cfl = 0.2;
      Simulation<Dim> simulation(std::move(model), std::move(state));
      for (int i = 0; i < 10; ++i) simulation.step();
      EXPECT_GT(simulation.state().bodies[0].slabs.count(), 2) << "nothing to share";
      const std::vector<double> now = fields_by_id(simulation);
      if (threads == 1) alone = now;
      ASSERT_EQ(now.size(), alone.size());
      EXPECT_EQ(std::memcmp(now.data(), alone.data(), now.size() * sizeof(double)), 0)
          << scheme_name << ", " << order.name << ", " << threads << " threads";
    }
  }
  omp_set_num_threads(1);
}

/// The data of the transfer for a point move with the point.
template <int Dim>
void expect_point_data_to_be_sorted(const TransferPointer<Dim>& chosen, const std::string& scheme_name) {
  State<Dim> state = scattered_block<Dim>(some_cells<Dim>(3), 1e5);
  Simulation<Dim> simulation(model_of<Dim>(scheme_name, chosen, musl_step<Dim>), std::move(state));
  Body<Dim>& body = simulation.state().bodies[0];
  Columns& data = body.points.transfer_data;
  ASSERT_EQ(data.components(), chosen->point_data_size());
  if (data.components() == 0) return;
  ASSERT_EQ(data.size(), body.points.size());
  const auto label = [&](Index id, int c) { return 100.0 * id + c; };
  for (Index p = 0; p < body.points.size(); ++p)
    for (int c = 0; c < data.components(); ++c) data[c][p] = label(body.points.id[static_cast<std::size_t>(p)], c);
  const std::vector<Index> before = body.points.id;
  for (Index p = 0; p < body.points.size(); ++p) body.points.position[0][p] *= -1.0; // from the last cell to the first
  sort_by_cell(simulation.state().grid, body.slabs.rows, body.points, body.slabs, body.sort_space);
  EXPECT_NE(body.points.id, before) << "nothing was sorted";
  for (Index p = 0; p < body.points.size(); ++p)
    for (int c = 0; c < data.components(); ++c)
      EXPECT_EQ(data[c][p], label(body.points.id[static_cast<std::size_t>(p)], c));
}

} // namespace riedel::test
