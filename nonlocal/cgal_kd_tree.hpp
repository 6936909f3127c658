/// Neighbours by CGAL's k-d tree.
#pragma once

#include "core/interface/neighbour_search.hpp"

namespace riedel {

/// Rebuilds the tree at each call: for scattered or very unevenly distributed points.
template <int Dim>
class CgalKdTree final : public NeighbourSearch<Dim> {
public:
  void find(const Columns& positions, double radius, NeighbourRows& rows) override;
};

/// Adds it, or, in a build without CGAL, a message on how to get it.
template <int Dim>
void add_cgal_kd_tree(NeighbourSearches<Dim>& searches);

} // namespace riedel
