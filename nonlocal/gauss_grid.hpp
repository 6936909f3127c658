/// The non-local average through a fine regular grid.
#pragma once

#include "core/interface/nonlocal_averager.hpp"
#include "nonlocal/kit/bounding_box.hpp"

namespace riedel {

/// The average of `gauss` to within 1e-3 of the range of a smooth field, at a cost that does not depend on the number
/// of neighbours: V_q and V_q field(q) are spread over nodes by quadratic B-splines, smoothed axis by axis, read at the
/// points by the same splines and divided. A spline adds Δ²/4 to the variance of the kernel along each axis, so the
/// filter's is smaller by Δ²/2. A uniform field is unchanged by any filter. See docs/theory/nonlocal.md.
///
/// Nodes are at integer multiples of the spacing, wherever the points are, so that the result does not depend, to the
/// bit, on when the grid was set up. A grid far too large for the number of points is refused with a RunError.
template <int Dim>
class GaussGridAverager final : public NonlocalAverager<Dim> {
public:
  static constexpr double default_spacing = 0.4;                        ///< Δ, in l_c [-]
  static constexpr double nodes_per_point = 64.0, nodes_more = 65536.0; ///< together they limit the number of nodes

  /// @param length l_c [m], > 0   @param spacing Δ, in l_c, 0.1 … 0.8 [-]
  explicit GaussGridAverager(double length, double spacing = default_spacing);

  void update_neighbours(const Columns& positions) override;
  void average(const double* volumes, const double* field, double* averaged) override;
  void invalidate() override { points_ = 0; }
  [[nodiscard]] double tolerance() const override { return 5e-3; } // its kernel is only approximately Gaussian
  [[nodiscard]] bool keeps_pairs() const override { return false; }
  /// Number of times that the grid was set up: at first, for other points and when a point has left it.
  [[nodiscard]] std::int64_t searches() const override { return layouts_; }

private:
  using Load = Eigen::Array2d; ///< on a node: Σ N V_q [m³ or m²] and Σ N V_q field(q), before and after smoothing
  using Splines = std::array<std::array<std::array<double, pack_size>, 3>, Dim>; ///< by axis, node and point

  static constexpr Index strip = 8; ///< layers of nodes along the last axis for one thread

  [[nodiscard]] Vec<Dim> node_at(const Vec<Dim>& place) const;
  [[nodiscard]] bool holds(const BoundingBox<Dim>& box) const;
  void lay_out(const Columns& positions, const BoundingBox<Dim>& box);
  [[noreturn]] void refuse(const Columns& positions, double nodes) const;
  void place(const Columns& positions, Range block);
  void evaluate(Index p, Splines& N) const;
  void spread(Index number, const double* volumes, const double* field);
  void smooth(int axis, const Load* from, Load* to) const;
  void read(const Load* nodes, Range block, double* averaged) const;
  [[nodiscard]] Index rows() const { return Dim == 2 ? count_[1] : count_[1] * count_[Dim - 1]; }
  [[nodiscard]] Load* nodes(int copy) { return nodes_[copy].data() + margin_; }

  double spacing_;                 ///< Δ [m]
  std::vector<double> taps_;       ///< of the filter, from −reach_ to reach_ nodes [-]
  Index reach_, margin_;           ///< nodes that smoothing uses on each side; width of the zeros around rows for that
  Index points_ = 0;               ///< for which the grid is set up
  Vec<Dim> first_;                 ///< node (0, 0[, 0]) of the grid, in spacings [-]
  Counts<Dim> count_{}, stride_{}; ///< nodes along each axis; from a node to the next along an axis
  Index lead_ = 0;                 ///< number of layers of the first strip before the grid
  std::array<AlignedVector<Load>, 2> nodes_; ///< smoothed from one to the other and back
  Columns offset_{Dim};                      ///< of a point from its node, in spacings, −0.5 … 0.5 [-]
  std::vector<Index> base_;                  ///< the first of the 3 × 3 [× 3] nodes around a point
  std::vector<Range> bases_;                 ///< per block, from the lowest base to one past the highest
  std::vector<BoundingBox<Dim>> boxes_;      ///< working space: per block
  std::int64_t layouts_ = 0;
};

} // namespace riedel
