/// The non-local average as a sum over pairs of points.
#pragma once

#include "core/base/columns.hpp"
#include "core/interface/nonlocal_averager.hpp"
#include "nonlocal/kit/bounding_box.hpp"
#include "nonlocal/kit/weight.hpp"

namespace riedel {

/// Averages with Gaussian weights. Krzyżanowski et al. (2020), eqs. (1) and (2).
///
/// Points near each other are also close in memory, so the neighbours of two consecutive points, a team, are covered by
/// runs of eight consecutive points that are summed as packs; a point in a run that is not a neighbour has a weight of
/// exactly zero. Weights are floats, the same in numerator and denominator: this costs up to 3e-7 of the field's range.
///
/// Neighbours are searched for within a skin around 3 l_c, and again only when two points may have approached each
/// other by the skin. The weights are kept until the distance of a pair may have changed by 2 `weights_last` l_c, by
/// which the error of the average is less than 5 weights_last times the largest difference of the field within 3 l_c
/// (see docs/theory/nonlocal.md). Volumes and the field are always the present ones. Memory: at most 12 bytes per
/// neighbour while points are numbered row by row of cells.
template <int Dim>
class GaussAverager final : public NonlocalAverager<Dim> {
public:
  static constexpr double skin = 0.1;          ///< width beyond 3 l_c, in l_c [-]
  static constexpr double weights_last = 2e-3; ///< half the change of distances for which weights are kept, in l_c [-]

  /// @param length l_c [m], > 0
  GaussAverager(double length, std::unique_ptr<NeighbourSearch<Dim>> search);

  void update_neighbours(const Columns& positions) override;
  void average(const double* volumes, const double* field, double* averaged) override;
  void invalidate() override;
  [[nodiscard]] std::int64_t searches() const override { return searches_; }

private:
  static constexpr Index team = 2; ///< consecutive points that share their runs
  static Index teams_of(Index points) { return (points + team - 1) / team; }

  void search(const Columns& positions);
  void append_runs(const NeighbourRows& rows, Index t, std::vector<Index>& runs) const;
  void lay_runs(const NeighbourRows& rows);
  void evaluate_weights(Range teams);
  void sum(Range teams, double* averaged) const;
  [[nodiscard]] bool shifted(const Columns& positions, const Columns& since, double distance);

  double length_; ///< l_c [m]
  GaussWeight weight_of_;
  std::unique_ptr<NeighbourSearch<Dim>> search_;
  Index points_ = 0;
  std::vector<std::int64_t> first_run_; ///< of each team
  std::vector<Index> run_;              ///< the first of the eight points of each run
  AlignedVector<float> weight_;         ///< ω of each run: eight per point of the team
  Columns load_{2};                     ///< V_q [m³ or m²] and V_q field(q); like places_, with eight more at the end
  Columns places_{Dim};                 ///< positions when weights were evaluated [m]
  Columns searched_at_{Dim};            ///< positions when neighbours were searched for [m]
  std::vector<BoundingBox<Dim>> boxes_; ///< working space of `shifted`
  std::int64_t searches_ = 0;
};

} // namespace riedel
