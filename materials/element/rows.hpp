/// Selects the points of a path that become rows of a curve, such that straight lines between them show it.
#pragma once

#include "core/base/thread_choice.hpp"
#include "materials/element/curve.hpp"
#include "materials/element/measures.hpp"

namespace riedel {

/// What a driver reports and queries during a test.
struct ElementWatch {
  std::function<void(const ElementRow&, const MaterialPoint&)> at_row; ///< called for each row, including the start
  std::function<bool()> stop;                                          ///< checked after each step
  ThreadRange threads = {};                                            ///< for a specimen of many points
};

class ElementRows {
public:
  /// @param void_ratio at the start, for a law without it @param every maximum strain between rows [-]
  ElementRows(const Material& law, double void_ratio, double every, Friction friction, const PoreWater& water,
              const ElementWatch& watch, std::vector<ElementRow>& rows);

  /// Sets the stage and the round of the following rows, both from 1.
  void begin(std::int64_t stage, std::int64_t cycle);
  /// Adds a row if the point is far enough from the last row. @throws RunError if there are too many
  void record(const MaterialPoint& point);
  /// Adds the last point as a row in any case.
  void write();

private:
  [[nodiscard]] ElementRow row_of(const MaterialPoint& point) const;
  [[nodiscard]] bool near(const ElementRow& a, const ElementRow& b) const;

  int column_; ///< of the void ratio in the state; −1: none
  double void_ratio_, every_;
  Friction friction_;
  PoreWater water_;
  std::int64_t stage_ = 1, cycle_ = 1;
  const ElementWatch& watch_;
  std::vector<ElementRow>& rows_;
  ElementRow last_;
  MaterialPoint point_;
  bool written_ = false;
};

} // namespace riedel
