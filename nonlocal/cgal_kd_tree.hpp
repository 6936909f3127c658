/// Neighbours by CGAL's k-d tree.
#pragma once

#include "core/interface/neighbour_search.hpp"

namespace riedel {

/// Builds the tree anew at each call: for spread-out or strongly uneven clouds of points.
template <int Dim>
class CgalKdTree final : public NeighbourSearch<Dim> {
public:
  void find(const Columns& positions, double radius, NeighbourRows& rows) override;
};

} // namespace riedel
