/// Points as a rate law sees them, and their way in and out of a batch's columns.
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

/// Up to eight consecutive points of a batch.
template <std::size_t States>
class BatchGroup {
public:
  BatchGroup(const MaterialBatch& batch, Index first)
      : batch_(batch), first_(first), size_(static_cast<int>(std::min<Index>(pack_size, batch.size - first))) {}

  [[nodiscard]] Index first() const { return first_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] double time_step() const { return batch_.time_step; }
  /// Of a column of the batch; lanes past the last point repeat it.
  [[nodiscard]] Pack load(const double* column) const {
    if (size_ == pack_size) return Pack::load(column + first_);
    std::array<double, pack_size> lane;
    for (int k = 0; k < pack_size; ++k) lane[k] = column[first_ + std::min(k, size_ - 1)];
    return Pack::load(lane.data());
  }
  void store(double* column, const Pack& value) const {
    if (size_ == pack_size) return value.store(column + first_);
    std::array<double, pack_size> lane;
    value.store(lane.data());
    std::copy_n(lane.data(), size_, column + first_);
  }

  [[nodiscard]] PointState<Pack, States> points() const {
    PointState<Pack, States> q;
    for (std::size_t c = 0; c < 6; ++c) q.stress.m[c] = load(batch_.stress[c]);
    for (std::size_t s = 0; s < States; ++s) q.state[s] = load(batch_.state[s]);
    return q;
  }
  void put(const PointState<Pack, States>& q) const {
    for (std::size_t c = 0; c < 6; ++c) store(batch_.stress[c], q.stress.m[c]);
    for (std::size_t s = 0; s < States; ++s) store(batch_.state[s], q.state[s]);
  }
  [[nodiscard]] Sym<Pack> rate() const {
    Sym<Pack> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = load(batch_.rate[c]);
    return D;
  }

  [[nodiscard]] PointState<double, States> point(int lane) const {
    PointState<double, States> q;
    for (std::size_t c = 0; c < 6; ++c) q.stress.m[c] = batch_.stress[c][first_ + lane];
    for (std::size_t s = 0; s < States; ++s) q.state[s] = batch_.state[s][first_ + lane];
    return q;
  }
  void put(int lane, const PointState<double, States>& q) const {
    for (std::size_t c = 0; c < 6; ++c) batch_.stress[c][first_ + lane] = q.stress.m[c];
    for (std::size_t s = 0; s < States; ++s) batch_.state[s][first_ + lane] = q.state[s];
  }
  [[nodiscard]] Sym<double> rate(int lane) const {
    Sym<double> D;
    for (std::size_t c = 0; c < 6; ++c) D.m[c] = batch_.rate[c][first_ + lane];
    return D;
  }
  /// The column behind the law's own: how far a frictional point has opened.
  [[nodiscard]] double* separation() const { return batch_.state[States]; }

private:
  const MaterialBatch& batch_;
  const Index first_;
  const int size_;
};

} // namespace riedel
