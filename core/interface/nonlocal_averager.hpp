/// Averages a scalar over the neighbourhood of each point of a body: a service for any scalar that a law names.
#pragma once

#include "core/interface/neighbour_search.hpp"

namespace riedel {

/// Contract, tested for every registered averager: a uniform field is unchanged, also at the edges.
template <int Dim>
class NonlocalAverager {
public:
  virtual ~NonlocalAverager() = default;
  NonlocalAverager() = default;
  NonlocalAverager(const NonlocalAverager&) = delete;
  NonlocalAverager& operator=(const NonlocalAverager&) = delete;

  /// Finds neighbours and weights for the present positions; to be called whenever the points have moved.
  /// @param positions Dim columns [m]
  virtual void update_neighbours(const Columns& positions) = 0;
  /// averaged(p) = Σ_q ω_pq V_q field(q) / Σ_q ω_pq V_q, with the weights of the last `update_neighbours`.
  /// @param volumes [m³ or m²] @param field, averaged columns with one number per point of the last update
  virtual void average(const double* volumes, const double* field, double* averaged) = 0;
  /// Must be called when points have been renumbered.
  virtual void invalidate() = 0;
  /// Largest deviation from the sum over all pairs, for a field that varies by one from point to point [-].
  [[nodiscard]] virtual double tolerance() const { return 3e-7; }
  /// Whether it stores each pair of neighbours, which takes most of a run's memory.
  [[nodiscard]] virtual bool keeps_pairs() const { return true; }
  /// Number of neighbour searches so far.
  [[nodiscard]] virtual std::int64_t searches() const = 0;
};

/// @param length characteristic length l_c [m], > 0
template <int Dim>
using NonlocalAveragers =
    Registry<std::unique_ptr<NonlocalAverager<Dim>>(double length, std::unique_ptr<NeighbourSearch<Dim>> search)>;

} // namespace riedel
