/// Averages a scalar over the neighbourhood of each point of a body: a service for any scalar that a law names.
#pragma once

#include "core/interface/neighbour_search.hpp"

namespace riedel {

/// Contract, tested for every registered averager: a uniform field stays as it is, also at the edges.
template <int Dim>
class NonlocalAverager {
public:
  virtual ~NonlocalAverager() = default;
  NonlocalAverager() = default;
  NonlocalAverager(const NonlocalAverager&) = delete;
  NonlocalAverager& operator=(const NonlocalAverager&) = delete;

  /// averaged(p) = Σ_q ω_pq V_q field(q) / Σ_q ω_pq V_q.
  /// @param positions Dim columns [m]   @param volumes [m³ or m²]   @param field, averaged columns of as many numbers
  virtual void average(const Columns& positions, const double* volumes, const double* field, double* averaged) = 0;
  /// Must be called when points have changed their numbers.
  virtual void forget_neighbours() = 0;
  /// Times that neighbours were searched for.
  [[nodiscard]] virtual std::int64_t searches() const = 0;
};

/// @param length characteristic length l_c [m], > 0
template <int Dim>
using NonlocalAveragers =
    Registry<std::unique_ptr<NonlocalAverager<Dim>>(double length, std::unique_ptr<NeighbourSearch<Dim>> search)>;

} // namespace riedel
