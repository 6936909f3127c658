#include "materials/umat/point.hpp"

#include "materials/umat/services.hpp"

#include <cmath>

namespace riedel {

namespace {

using Six = std::array<double, 6>;
using Matrix = Eigen::Matrix3d;

void scale(Six& a, double normal, double shear) {
  for (std::size_t c = 0; c < 6; ++c) a[c] *= c < 3 ? normal : shear;
}

/// From columns, row by row, to one matrix by columns.
std::array<double, 9> by_columns(const std::array<const double*, 9>& rows, Index p) {
  std::array<double, 9> all{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) all[j * 3 + i] = rows[i * 3 + j][p];
  return all;
}

void rotate(Six& a, const Matrix& Q, int kind) {
  const int three = 3;
  const Six before = a;
  rotsig_(before.data(), Q.data(), a.data(), &kind, &three, &three);
}

} // namespace

UmatPoint umat_point(const MaterialBatch& batch, Index p, const UmatStates& states, double stress_unit) {
  UmatPoint point(states.size());
  UmatCall& call = point.call;
  for (std::size_t s = 0; s < states.size(); ++s) point.state[s] = states.factor(s) * batch.state[s][p];
  double squares = 0.0;
  for (std::size_t c = 0; c < 6; ++c) {
    call.stress[c] = batch.stress[c][p];
    call.strain[c] = batch.state[states.size() + c][p];
    call.strain_increment[c] = batch.rate[c] == nullptr ? 0.0 : batch.rate[c][p] * batch.time_step;
    squares += call.strain_increment[c] * call.strain_increment[c];
  }
  call.field_increment = batch.averaged != nullptr ? batch.averaged[p] * batch.time_step : std::sqrt(squares);
  scale(call.stress, 1.0 / stress_unit, umat_stress_shear / stress_unit);
  scale(call.strain, 1.0, umat_strain_shear);
  scale(call.strain_increment, 1.0, umat_strain_shear);
  call.time = {batch.stage_time, batch.time};
  call.time_step = batch.time_step;
  call.point = static_cast<int>(batch.id != nullptr ? batch.id[p] : p) + 1;
  call.increment = static_cast<int>(batch.increment);
  call.stage = batch.stage;
  if (batch.motion == nullptr) return point;
  call.rotation = by_columns(batch.motion->rotation, p);
  call.motion_before = by_columns(batch.motion->gradient_before, p);
  call.motion_after = by_columns(batch.motion->deformation_gradient, p);
  return point;
}

void give_back(const UmatPoint& point, const MaterialBatch& batch, Index p, const UmatStates& states,
               double stress_unit) {
  Six stress = point.call.stress, strain = point.call.strain;
  scale(stress, stress_unit, stress_unit / umat_stress_shear);
  scale(strain, 1.0, 1.0 / umat_strain_shear);
  for (std::size_t s = 0; s < states.size(); ++s) batch.state[s][p] = point.state[s] / states.factor(s);
  for (std::size_t c = 0; c < 6; ++c) {
    batch.stress[c][p] = stress[c];
    batch.state[states.size() + c][p] = strain[c];
  }
}

UmatParts::UmatParts(const UmatPoint& whole, const UmatStates& states)
    : states_(states), whole_(whole), now_(whole), rotation_(Matrix(whole.call.rotation.data())) {
  turn(now_, turned(-1.0));
}

Matrix UmatParts::turned(double share) const {
  return Eigen::AngleAxisd(share * rotation_.angle(), rotation_.axis()).toRotationMatrix();
}

void UmatParts::turn(UmatPoint& point, const Matrix& Q) const {
  if (rotation_.angle() == 0.0) return;
  rotate(point.call.stress, Q, 1);
  rotate(point.call.strain, Q, 2);
  states_.rotate(point.state.data(), Q.data());
}

UmatPoint UmatParts::next(double share) const {
  UmatPoint part = now_;
  UmatCall& call = part.call;
  const UmatCall& whole = whole_.call;
  const Matrix Q = turned(share);
  turn(part, Q);
  std::copy_n(Q.data(), 9, call.rotation.begin());
  for (std::size_t c = 0; c < 9; ++c) {
    const double before = whole.motion_before[c], after = whole.motion_after[c];
    call.motion_before[c] = std::lerp(before, after, done_);
    call.motion_after[c] = std::lerp(before, after, done_ + share);
  }
  for (std::size_t c = 0; c < 6; ++c) call.strain_increment[c] = share * whole.strain_increment[c];
  rotate(call.strain_increment, turned(done_ + share - 1.0), 2); // in the frame at the part's end
  call.time_step = share * whole.time_step;
  call.field_increment = share * whole.field_increment;
  for (std::size_t t = 0; t < 2; ++t) call.time[t] = whole.time[t] + done_ * whole.time_step;
  call.time_step_factor = 1.0;
  return part;
}

void UmatParts::keep(const UmatPoint& answer, double share) {
  now_ = answer;
  done_ += share;
}

} // namespace riedel
