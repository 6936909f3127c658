/// The fields of points, independent of their order.
#pragma once

#include "core/step/simulation.hpp"

namespace riedel::test {

/// All fields of all points, by id.
template <int Dim>
std::vector<double> fields_by_id(Simulation<Dim>& simulation) {
  std::vector<double> all;
  Points<Dim>& points = simulation.state().bodies[0].points;
  for (Index id = 0; id < points.size(); ++id)
    for (const Columns* field : points.fields())
      for (int c = 0; c < field->components(); ++c)
        all.push_back((*field)[c][points.place[static_cast<std::size_t>(id)]]);
  return all;
}

} // namespace riedel::test
