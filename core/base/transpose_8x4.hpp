/// Transposes four packs into eight rows of four doubles, and back.
#pragma once

#include "core/base/pack.hpp"
#include "core/base/short_vector.hpp"

#include <cstring>

namespace riedel {

/// Eight rows of four doubles, one for each of eight points; packs are the columns.
class Transpose8x4 {
public:
  [[nodiscard]] double* row(Index k) { return row_[k].data(); }
  [[nodiscard]] const double* row(Index k) const { return row_[k].data(); }

  void put(const std::array<Pack, 4>& column) {
    Eight a, b, c, d;
    copy(column[0], a), copy(column[1], b), copy(column[2], c), copy(column[3], d);
    const Eight even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Eight odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const Eight even_end = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const Eight odd_end = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    put_pair(0, __builtin_shufflevector(even, even_end, 0, 1, 8, 9, 4, 5, 12, 13));
    put_pair(1, __builtin_shufflevector(odd, odd_end, 0, 1, 8, 9, 4, 5, 12, 13));
    put_pair(2, __builtin_shufflevector(even, even_end, 2, 3, 10, 11, 6, 7, 14, 15));
    put_pair(3, __builtin_shufflevector(odd, odd_end, 2, 3, 10, 11, 6, 7, 14, 15));
  }
  [[nodiscard]] std::array<Pack, 4> columns() const {
    Eight r04, r15, r26, r37;
    get_pair(0, r04), get_pair(1, r15), get_pair(2, r26), get_pair(3, r37);
    const Eight even = __builtin_shufflevector(r04, r26, 0, 1, 8, 9, 4, 5, 12, 13);
    const Eight odd = __builtin_shufflevector(r15, r37, 0, 1, 8, 9, 4, 5, 12, 13);
    const Eight even_end = __builtin_shufflevector(r04, r26, 2, 3, 10, 11, 6, 7, 14, 15);
    const Eight odd_end = __builtin_shufflevector(r15, r37, 2, 3, 10, 11, 6, 7, 14, 15);
    return {pack(__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14)),
            pack(__builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)),
            pack(__builtin_shufflevector(even_end, odd_end, 0, 8, 2, 10, 4, 12, 6, 14)),
            pack(__builtin_shufflevector(even_end, odd_end, 1, 9, 3, 11, 5, 13, 7, 15))};
  }

private:
  using Eight = ShortVector<8>::Lanes;
  // By reference: compilers disagree on how to return vectors that the processor lacks.
  static void copy(const Pack& pack, Eight& lanes) { std::memcpy(&lanes, &pack, sizeof(lanes)); }
  /// Not std::bit_cast, whose reference parameter assumes more alignment than clang gives its vectors.
  static Pack pack(const Eight& lanes) { return __builtin_bit_cast(Pack, lanes); }
  /// Rows k and k + 4.
  void put_pair(Index k, const Eight& rows) {
    ShortVector<4> half;
    half.lanes = __builtin_shufflevector(rows, rows, 0, 1, 2, 3);
    half.store(row(k));
    half.lanes = __builtin_shufflevector(rows, rows, 4, 5, 6, 7);
    half.store(row(k + 4));
  }
  void get_pair(Index k, Eight& rows) const {
    rows = __builtin_shufflevector(ShortVector<4>::load(row(k)).lanes, ShortVector<4>::load(row(k + 4)).lanes, 0, 1, 2,
                                   3, 4, 5, 6, 7);
  }
  alignas(64) std::array<std::array<double, 4>, pack_size> row_;
};

} // namespace riedel
