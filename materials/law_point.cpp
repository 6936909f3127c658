#include "materials/law_point.hpp"

#include <Eigen/Geometry>

namespace riedel {

namespace {

/// A batch of one.
struct Lone {
  std::array<double, 6> rate{};
  std::vector<double*> columns;
  MaterialBatch batch;

  Lone(LawPoint& point, const Sym<double>& D, double time) : rate(D.m) {
    for (double& value : point.state) columns.push_back(&value);
    batch.size = 1;
    batch.time_step = time;
    for (std::size_t c = 0; c < 6; ++c) {
      batch.stress[c] = &point.stress.m[c];
      batch.rate[c] = &rate[c];
    }
    batch.state = columns;
  }
};

/// exp(A) of a small matrix, by its series.
Mat<3> exponential(const Mat<3>& A) {
  constexpr int terms = 14; // 1e-16 for ‖A‖ ≤ 0.5
  Mat<3> sum = Mat<3>::Identity(), term = sum;
  for (int k = 1; k <= terms; ++k) sum += term = term * A / k;
  return sum;
}

/// exp(W) of half the spin of an increment, as a turn about its axis.
Mat<3> half_rotation(const Mat<3>& increment) {
  const Mat<3> W = 0.25 * (increment - increment.transpose());
  const Vec<3> axis(W(2, 1), W(0, 2), W(1, 0));
  const double angle = axis.norm();
  if (angle == 0.0) return Mat<3>::Identity();
  return Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
}

void rotate(Sym<double>& a, const Mat<3>& Q) { a = to_sym(Q * to_matrix(a) * Q.transpose()); }

void rotate_tensors(const Material& law, LawPoint& point, const Mat<3>& Q) {
  rotate(point.stress, Q);
  std::size_t column = 0;
  for (const StateVariable& variable : law.states()) {
    if (variable.components == 6) {
      Sym<double> tensor;
      std::copy_n(point.state.begin() + static_cast<std::ptrdiff_t>(column), 6, tensor.m.begin());
      rotate(tensor, Q);
      std::copy_n(tensor.m.begin(), 6, point.state.begin() + static_cast<std::ptrdiff_t>(column));
    }
    column += static_cast<std::size_t>(variable.components);
  }
}

} // namespace

LawPoint deformed(const Material& law, LawPoint point, const Mat<3>& increment, double time, MaterialReport& report) {
  const Mat<3> Q = half_rotation(increment);
  const Sym<double> strain = to_sym(increment);
  const bool spins = increment != increment.transpose();
  if (spins) rotate_tensors(law, point, Q);
  const Lone lone(point, strain / time, time);
  law.integrate(lone.batch, report);
  if (spins) rotate_tensors(law, point, Q);
  point.F = exponential(increment) * point.F;
  point.strain = point.strain + strain;
  point.time += time;
  return point;
}

Survey survey(const Material& law, LawPoint point) { return law.survey(Lone(point, Sym<double>::zero(), 0.0).batch); }

} // namespace riedel
