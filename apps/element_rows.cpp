#include "apps/element_rows.hpp"

#include <Eigen/LU>

namespace riedel {

ElementRows::ElementRows(const Material& law, double void_ratio, double every, Friction friction,
                         const ElementWatch& watch, std::vector<ElementRow>& rows)
    : column_(state_column(law.states(), "void_ratio")),
      void_ratio_(void_ratio),
      every_(every),
      friction_(friction),
      watch_(watch),
      rows_(rows) {}

void ElementRows::look(const LawPoint& point) {
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

ElementRow ElementRows::row_of(const LawPoint& point) const {
  const double e = column_ >= 0 ? point.state[static_cast<std::size_t>(column_)]
                                : (1.0 + void_ratio_) * point.F.determinant() - 1.0; // a law that carries none
  return element_row(point, e, friction_);
}

bool ElementRows::near(const ElementRow& a, const ElementRow& b) const {
  constexpr double angle = 0.1, share = 0.005; // [deg], of the stress
  double strain = std::abs(a.gamma - b.gamma), change = std::abs(a.tau - b.tau), size = std::abs(b.tau);
  for (std::size_t c = 0; c < 3; ++c) {
    strain = std::max(strain, std::abs(a.eps[c] - b.eps[c]));
    change = std::max(change, std::abs(a.sigma[c] - b.sigma[c]));
    size = std::max(size, std::abs(b.sigma[c]));
  }
  return strain < every_ && change < share * size && std::abs(a.phi_mob - b.phi_mob) < angle;
}

} // namespace riedel
