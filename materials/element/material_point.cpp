#include "materials/element/material_point.hpp"

#include "core/base/error.hpp"

#include <Eigen/Geometry>

namespace riedel {

namespace {

/// Row by row, as columns for a batch of one point.
struct RowByRow {
  std::array<double, 9> entries;
  explicit RowByRow(const Mat<3>& a) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) entries[static_cast<std::size_t>(i * 3 + j)] = a(i, j);
  }
  void fill(std::array<const double*, 9>& columns) const {
    for (std::size_t c = 0; c < 9; ++c) columns[c] = &entries[c];
  }
};

/// The motion of a point in one step.
struct Course {
  double time = 0.0;                                           ///< Δt [s]
  Mat<3> L = Mat<3>::Zero(), F, rotation = Mat<3>::Identity(); ///< F at the end
};

/// A batch of one.
struct Lone {
  std::array<double, 6> rate{};
  std::vector<double*> columns;
  RowByRow L, before, after, rotation;
  Motion motion;
  Index id = 0;
  MaterialBatch batch;

  Lone(MaterialPoint& point, const Course& course)
      : rate(to_sym(course.L).m), L(course.L), before(point.F), after(course.F), rotation(course.rotation) {
    for (double& value : point.state) columns.push_back(&value);
    L.fill(motion.velocity_gradient);
    before.fill(motion.gradient_before);
    after.fill(motion.deformation_gradient);
    rotation.fill(motion.rotation);
    batch.size = 1;
    batch.time_step = course.time;
    batch.time = point.time;
    batch.stage_time = point.time - point.stage_start;
    batch.stage = point.stage;
    batch.increment = point.increments + 1;
    for (std::size_t c = 0; c < 6; ++c) {
      batch.stress[c] = &point.stress.m[c];
      batch.rate[c] = &rate[c];
    }
    batch.state = columns;
    batch.motion = &motion;
    batch.id = &id;
  }
};

/// exp(A), by its series; for a large matrix as exp(A/2)².
Mat<3> exponential(const Mat<3>& A) {
  constexpr int terms = 14; // 1e-16 for ‖A‖ ≤ 0.5
  if (A.norm() > 0.5 && A.allFinite()) {
    const Mat<3> root = exponential(A / 2);
    return root * root;
  }
  Mat<3> sum = Mat<3>::Identity(), term = sum;
  for (int k = 1; k <= terms; ++k) sum += term = term * A / k;
  return sum;
}

/// exp(W) of half the spin of an increment, as a rotation about its axis.
Mat<3> half_rotation(const Mat<3>& increment) {
  const Mat<3> W = 0.25 * (increment - increment.transpose());
  const Vec<3> axis(W(2, 1), W(0, 2), W(1, 0));
  const double angle = axis.norm();
  if (angle == 0.0) return Mat<3>::Identity();
  return Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
}

void rotate(Sym<double>& a, const Mat<3>& Q) { a = to_sym(Q * to_matrix(a) * Q.transpose()); }

} // namespace

void rotate_tensors(const Material& law, MaterialPoint& point, const Mat<3>& Q) {
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

void begin_stage(MaterialPoint& point) {
  ++point.stage;
  point.stage_start = point.time;
  point.increments = 0;
}

namespace {

/// Rotates stress and tensors to the end of a step. @return the step
Course begin_step(const Material& law, MaterialPoint& point, const Mat<3>& increment, double time) {
  Course course{.time = time, .L = increment / time, .F = exponential(increment) * point.F};
  if (increment == increment.transpose()) return course;
  const Mat<3> half = half_rotation(increment);
  course.rotation = half * half;
  course.L = half * course.L * half.transpose();
  rotate_tensors(law, point, course.rotation);
  return course;
}

} // namespace

MaterialPoint deformed(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                       MaterialReport& report) {
  const Course course = begin_step(law, point, increment, time);
  try {
    law.integrate(Lone(point, course).batch, report);
  } catch (const std::exception& error) {
    throw RunError(std::string("the law failed: ") + error.what());
  } catch (...) { throw RunError("the law failed: it threw an exception of an unknown type"); }
  point.F = course.F;
  point.strain = point.strain + to_sym(increment);
  point.time += time;
  ++point.increments;
  return point;
}

void with_batch(const Material& law, MaterialPoint point, const Mat<3>& increment, double time,
                const std::function<void(const MaterialBatch&)>& use) {
  const Course course = begin_step(law, point, increment, time);
  use(Lone(point, course).batch);
}

MaterialLimits assess(const Material& law, MaterialPoint point) {
  return law.assess(Lone(point, {.F = point.F}).batch);
}

} // namespace riedel
