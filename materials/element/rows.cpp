#include "materials/element/rows.hpp"

#include "core/base/error.hpp"

#include <Eigen/LU>

namespace riedel {

ElementRows::ElementRows(const Material& law, double void_ratio, double every, Friction friction,
                         const PoreWater& water, const ElementWatch& watch, std::vector<ElementRow>& rows)
    : column_(state_column(law.states(), "void_ratio")),
      void_ratio_(void_ratio),
      every_(every),
      friction_(friction),
      water_(water),
      watch_(watch),
      rows_(rows) {}

void ElementRows::begin(std::int64_t stage, std::int64_t cycle) {
  stage_ = stage;
  cycle_ = cycle;
}

void ElementRows::record(const MaterialPoint& point) {
  if (rows_.size() >= max_element_rows)
    throw RunError("there are " + std::to_string(rows_.size()) +
                   " rows, the maximum: take a larger output.every_strain, or fewer rounds");
  last_ = row_of(point);
  point_ = point;
  written_ = false;
  if (rows_.empty() || !near(rows_.back(), last_)) write();
}

void ElementRows::write() {
  if (written_) return;
  rows_.push_back(last_);
  watch_.at_row(last_, point_);
  written_ = true;
}

ElementRow ElementRows::row_of(const MaterialPoint& point) const {
  const double e = column_ >= 0 ? point.state[static_cast<std::size_t>(column_)]
                                : (1.0 + void_ratio_) * point.F.determinant() - 1.0; // for a law without it
  ElementRow row = element_row(point, e, friction_, water_.present() ? water_.pressure(point) : 0.0);
  row.stage = stage_;
  row.cycle = cycle_;
  return row;
}

bool ElementRows::near(const ElementRow& a, const ElementRow& b) const {
  constexpr double usual = 5e-4; // strain between rows, unless fewer rows are requested [-]
  const double coarser = std::max(1.0, every_ / usual);
  const double angle = 0.1 * coarser, share = 0.005 * coarser; // [deg], of the stress
  double strain = std::abs(a.gamma - b.gamma), change = std::abs(a.tau - b.tau), size = std::abs(b.tau);
  for (std::size_t c = 0; c < 3; ++c) {
    strain = std::max(strain, std::abs(a.eps[c] - b.eps[c]));
    change = std::max(change, std::abs(a.sigma[c] - b.sigma[c]));
    size = std::max(size, std::abs(b.sigma[c]));
  }
  return strain < every_ && change < share * size && std::abs(a.phi_mob - b.phi_mob) < angle;
}

} // namespace riedel
