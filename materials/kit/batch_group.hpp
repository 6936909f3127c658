/// Points as passed to a rate law, and their transfer to and from a batch's columns.
#pragma once

#include "core/base/tensor.hpp"
#include "core/interface/material.hpp"

namespace riedel {

/// Stress and the law's own state variables at one point, or at eight.
template <class Real, std::size_t States>
struct PointState {
  Sym<Real> stress;
  std::array<Real, States> state;
};

template <class Real, std::size_t States>
PointState<Real, States> select(const MaskOf<Real>& m, PointState<Real, States> yes,
                                const PointState<Real, States>& no) {
  for (std::size_t c = 0; c < 6; ++c) yes.stress.m[c] = select(m, yes.stress.m[c], no.stress.m[c]);
  for (std::size_t s = 0; s < States; ++s) yes.state[s] = select(m, yes.state[s], no.state[s]);
  return yes;
}

/// Consecutive points of a batch: one (Real = double) or up to eight (Real = Pack).
template <class Real, std::size_t States>
class BatchGroup {
public:
  BatchGroup(const MaterialBatch& batch, Index first)
      : batch_(batch), first_(first), size_(static_cast<int>(std::min<Index>(lane_count<Real>, batch.size - first))) {}

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] double time_step() const { return batch_.time_step; }
  [[nodiscard]] const double* averaged() const { return batch_.averaged; }
  /// The column after the law's own: how far a frictional point has opened.
  [[nodiscard]] const double* separation() const { return batch_.state[States]; }

  /// Values of a column of the batch; lanes past the last point repeat it.
  [[nodiscard]] Real load(const double* column) const {
    if constexpr (lane_count<Real> == 1) {
      return column[first_];
    } else {
      if (size_ == pack_size) return Pack::load(column + first_);
      std::array<double, pack_size> lane;
      for (int k = 0; k < pack_size; ++k) lane[k] = column[first_ + std::min(k, size_ - 1)];
      return Pack::load(lane.data());
    }
  }
  void store(double* column, const Real& value) const {
    if constexpr (lane_count<Real> == 1) {
      column[first_] = value;
    } else {
      if (size_ == pack_size) return value.store(column + first_);
      std::array<double, pack_size> lane;
      value.store(lane.data());
      std::copy_n(lane.data(), size_, column + first_);
    }
  }

  [[nodiscard]] PointState<Real, States> points() const {
    PointState<Real, States> q;
    for (std::size_t c = 0; c < 6; ++c) q.stress.m[c] = load(batch_.stress[c]);
    for (std::size_t s = 0; s < States; ++s) q.state[s] = load(batch_.state[s]);
    return q;
  }
  void put(const PointState<Real, States>& q) const {
    for (std::size_t c = 0; c < 6; ++c) store(batch_.stress[c], q.stress.m[c]);
    for (std::size_t s = 0; s < States; ++s) store(batch_.state[s], q.state[s]);
  }
  [[nodiscard]] Sym<Real> rate() const {
    Sym<Real> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = load(batch_.rate[c]);
    return D;
  }

private:
  const MaterialBatch& batch_;
  const Index first_;
  const int size_;
};

} // namespace riedel
