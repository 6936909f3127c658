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

/// Adds it, or, in a build without CGAL, tells how to get it.
template <int Dim>
void add_cgal_kd_tree(NeighbourSearches<Dim>& searches);

} // namespace riedel
