/// The non-local average as a sum over pairs of points.
#pragma once

#include "core/base/columns.hpp"
#include "core/interface/nonlocal_averager.hpp"
#include "nonlocal/weight.hpp"

namespace riedel {

/// Averages with Gauss's weights. Krzyżanowski et al. (2020), eqs. (1) and (2).
///
/// Neighbours are searched for within a skin around 3 l_c, and again only when a point has moved by half the skin. The
/// weights of the pairs are kept until a point has moved by `weights_last` l_c: each distance is then wrong by at most
/// twice that, and the average by less than 5 weights_last times the largest difference of the field within 3 l_c (see
/// docs/theory/nonlocal.md). Volumes and the field are always the present ones. Memory: 12 bytes per neighbour.
template <int Dim>
class GaussAverager final : public NonlocalAverager<Dim> {
public:
  static constexpr double skin = 0.1;          ///< searched for beyond 3 l_c, in l_c [-]
  static constexpr double weights_last = 2e-3; ///< way of a point after which weights are evaluated anew, in l_c [-]

  /// @param length l_c [m], > 0
  GaussAverager(double length, std::unique_ptr<NeighbourSearch<Dim>> search);

  void follow(const Columns& positions) override;
  void average(const double* volumes, const double* field, double* averaged) override;
  void forget_neighbours() override;
  [[nodiscard]] std::int64_t searches() const override { return searches_; }

private:
  /// What a neighbour brings to the two sums.
  struct Load {
    double volume; ///< V_q [m³ or m²]
    double moment; ///< V_q field(q)
  };

  void search(const Columns& positions);
  void weigh(const Columns& positions, Range block);
  [[nodiscard]] bool moved(const Columns& positions, const Columns& since, double distance);

  double length_; ///< l_c [m]
  GaussWeight weight_of_;
  std::unique_ptr<NeighbourSearch<Dim>> search_;
  NeighbourRows rows_;           ///< pairs within 3 l_c and the skin
  AlignedVector<double> weight_; ///< ω of each pair; exactly zero beyond 3 l_c
  AlignedVector<Load> load_;
  Columns searched_at_{Dim}; ///< positions when neighbours were searched for [m]
  Columns weighed_at_{Dim};  ///< positions when weights were evaluated [m]
  std::vector<char> stayed_; ///< working space of `moved`, a flag per block
  std::int64_t searches_ = 0;
};

} // namespace riedel
