/// Decides which points of a path become rows of a curve: straight lines between them show it.
#pragma once

#include "core/base/thread_choice.hpp"
#include "materials/element/curve.hpp"
#include "materials/element/measures.hpp"

namespace riedel {

/// What a driver tells, and asks, on its way.
struct ElementWatch {
  std::function<void(const ElementRow&, const MaterialPoint&)> at_row; ///< for each row, the start included
  std::function<bool()> stop;                                          ///< asked after each step
  ThreadRange threads = {};                                            ///< of a specimen of many points
};

class ElementRows {
public:
  /// @param void_ratio at the start, for a law that carries none   @param every strain between rows at most [-]
  ElementRows(const Material& law, double void_ratio, double every, Friction friction, const PoreWater& water,
              const ElementWatch& watch, std::vector<ElementRow>& rows);

  /// What follows belongs to this stage, in this round, both from 1.
  void begin(std::int64_t stage, std::int64_t cycle);
  /// A row, if the point lies far enough from the last one. @throws RunError when there are too many
  void record(const MaterialPoint& point);
  /// The last point looked at becomes a row, wherever it lies.
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
