/// One field of many points: a column per component, each contiguous, aligned to cache lines and padded with zeros to
/// whole packs, so that a pack may be read past the last point.
#pragma once

#include "core/base/parallel.hpp"

#include <memory>
#include <new>
#include <vector>

namespace riedel {

/// Allocator for cache-line aligned vectors of plain numbers.
template <class T>
struct Aligned {
  using value_type = T;
  Aligned() = default;
  template <class U>
  Aligned(const Aligned<U>&) {} // NOLINT: allocators convert
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(64)); }
  template <class U>
  bool operator==(const Aligned<U>&) const {
    return true;
  }
};
template <class T>
using AlignedVector = std::vector<T, Aligned<T>>;

class Columns {
public:
  explicit Columns(int components) : components_(components) {}

  void resize(Index size) {
    size_ = size;
    stride_ = (size + pack_size - 1) / pack_size * pack_size;
    data_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(components_), 0.0);
  }
  [[nodiscard]] Index size() const { return size_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] double* operator[](int component) { return data_.data() + std::ptrdiff_t{component} * stride_; }
  [[nodiscard]] const double* operator[](int component) const {
    return data_.data() + std::ptrdiff_t{component} * stride_;
  }
  void fill(int component, double value) { std::fill_n((*this)[component], size_, value); }

  /// Entry i becomes the previous entry order[i]. @param scratch working space, kept by the caller
  void reorder(const std::vector<Index>& order, AlignedVector<double>& scratch) {
    scratch.resize(static_cast<std::size_t>(size_));
    for (int c = 0; c < components_; ++c) {
      double* column = (*this)[c];
      parallel_for(size_, [&](Index i) { scratch[i] = column[order[i]]; });
      parallel_for(size_, [&](Index i) { column[i] = scratch[i]; });
    }
  }

private:
  int components_;
  Index size_ = 0;
  std::ptrdiff_t stride_ = 0;
  AlignedVector<double> data_;
};

} // namespace riedel
