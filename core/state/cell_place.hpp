/// A position on the grid, and the multilinear hats of the cell that contains it.
#pragma once

#include "core/state/grid.hpp"

#include <cmath>

namespace riedel {

/// Corner n of the cell, n from 0 to 2ᵈ − 1, is on the upper side along axis a if bit a of n is set.
template <int Dim>
class CellPlace {
public:
  CellPlace(const Grid<Dim>& grid, const Vec<Dim>& x) : strides_(grid.strides()) {
    for (int a = 0; a < Dim; ++a) {
      const double s = (x[a] - grid.origin[a]) / grid.cell[a], low = std::floor(s);
      inside_ = inside_ && low >= 0.0 && low + 2 <= grid.nodes[a]; // also false for NaN
      first_[a] = inside_ ? static_cast<Index>(low) : 0;
      xi_[a] = s - low;
    }
    base_ = grid.node(first_);
  }

  [[nodiscard]] bool inside() const { return inside_; }       ///< the grid; otherwise hats and nodes are meaningless
  [[nodiscard]] Index row() const { return first_[Dim - 1]; } ///< index of the lowest node along the last axis
  [[nodiscard]] Index node(int n) const {
    Index node = base_;
    for (int a = 0; a < Dim; ++a)
      if ((n >> a) & 1) node += strides_[a];
    return node;
  }
  [[nodiscard]] double hat(int n) const { ///< N of corner n [-]
    double N = 1.0;
    for (int a = 0; a < Dim; ++a) N *= (n >> a) & 1 ? xi_[a] : 1.0 - xi_[a];
    return N;
  }

private:
  Counts<Dim> strides_, first_{};
  Vec<Dim> xi_; ///< position in the cell, 0 to 1
  Index base_ = 0;
  bool inside_ = true;
};

} // namespace riedel
