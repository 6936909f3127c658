/// Decides which points of a path become rows of a curve: straight lines between them show it.
#pragma once

#include "apps/element_drivers.hpp"

namespace riedel {

class ElementRows {
public:
  /// @param void_ratio at the start, for a law that carries none   @param every strain between rows at most [-]
  ElementRows(const Material& law, double void_ratio, double every, Friction friction, const ElementWatch& watch,
              std::vector<ElementRow>& rows);

  /// A row, if the point lies far enough from the last one.
  void look(const LawPoint& point);
  /// The last point looked at becomes a row, wherever it lies.
  void write();

private:
  [[nodiscard]] ElementRow row_of(const LawPoint& point) const;
  [[nodiscard]] bool near(const ElementRow& a, const ElementRow& b) const;

  int column_; ///< of the void ratio in the state; −1: none
  double void_ratio_, every_;
  Friction friction_;
  const ElementWatch& watch_;
  std::vector<ElementRow>& rows_;
  ElementRow last_;
  LawPoint point_;
  bool written_ = false;
};

} // namespace riedel
