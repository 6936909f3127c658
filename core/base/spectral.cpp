#include "core/base/spectral.hpp"

namespace riedel {

namespace {
/// One rotation in the plane of axes i and j that makes a_ij zero: Jacobi's method, Golub & Van Loan, section 8.5.
void rotate_out(Mat<3>& a, Mat<3>& v, int i, int j) {
  if (a(i, j) == 0.0) return;
  const double theta = 0.5 * (a(j, j) - a(i, i)) / a(i, j);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(1.0 + theta * theta));
  const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
  const double step = t * a(i, j);
  const int k = 3 - i - j;
  const double a_ki = a(k, i), a_kj = a(k, j);
  a(i, i) -= step;
  a(j, j) += step;
  a(i, j) = a(j, i) = 0.0;
  a(k, i) = a(i, k) = c * a_ki - s * a_kj;
  a(k, j) = a(j, k) = s * a_ki + c * a_kj;
  const Vec<3> v_i = v.col(i);
  v.col(i) = c * v_i - s * v.col(j);
  v.col(j) = s * v_i + c * v.col(j);
}
} // namespace

Spectral spectral(const Sym<double>& given) {
  constexpr int max_sweeps = 20; // convergence is quadratic: four or five are enough
  Mat<3> a = to_matrix(given);
  Spectral answer{.values = {}, .directions = Mat<3>::Identity()};
  const double negligible = 1e-34 * a.squaredNorm();
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    const double off = a(0, 1) * a(0, 1) + a(0, 2) * a(0, 2) + a(1, 2) * a(1, 2);
    if (!(off > negligible)) break;
    rotate_out(a, answer.directions, 0, 1);
    rotate_out(a, answer.directions, 0, 2);
    rotate_out(a, answer.directions, 1, 2);
  }
  answer.values = a.diagonal();
  if (!std::isfinite(a.sum())) answer.values.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}})
    if (answer.values[i] < answer.values[j]) {
      std::swap(answer.values[i], answer.values[j]);
      answer.directions.col(i).swap(answer.directions.col(j));
    }
  return answer;
}

Sym<double> from_spectral(const Vec<3>& values, const Mat<3>& directions) {
  return to_sym(directions * values.asDiagonal() * directions.transpose());
}

Sym<double> congruent(const Sym<double>& a, const Sym<double>& b) {
  const Mat<3> outer = to_matrix(a);
  return to_sym(outer * to_matrix(b) * outer);
}

} // namespace riedel
