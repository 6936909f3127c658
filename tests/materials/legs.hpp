/// Legs of paths for a point driver.
#pragma once

#include "materials/element/point_driver.hpp"
#include "support/problems.hpp"

#include <Eigen/LU>

namespace riedel::test {

inline constexpr double degrees = 180.0 / std::numbers::pi, sqrt2 = std::numbers::sqrt2;

inline Condition stretch(int axis, double target) {
  return {"eps_" + std::to_string(axis + 1), [=](const MaterialPoint& q) { return q.F(axis, axis); }, target, false};
}
inline Condition shear(int i, int j, double target) {
  return {"gamma", [=](const MaterialPoint& q) { return q.F(i, j); }, target, false};
}
inline Condition stress(std::size_t axis, double target) {
  return {"sigma_" + std::to_string(axis + 1), [=](const MaterialPoint& q) { return q.stress.m[axis]; }, target, true};
}
inline Condition volume(double target) {
  return {"volume", [](const MaterialPoint& q) { return q.F.determinant(); }, target, false};
}
inline LoadStep leg_of(Condition a, Condition b, Condition c, double gamma = 0.0) {
  return {.conditions = {std::move(a), std::move(b), std::move(c), shear(0, 1, gamma), shear(0, 2, 0), shear(1, 2, 0)}};
}
inline LoadStep triaxial(double u, double p) { return leg_of(stretch(0, 1 - u), stress(1, -p), stress(2, -p)); }
inline LoadStep plane_strain(double u, double p) { return leg_of(stretch(0, 1 - u), stress(1, -p), stretch(2, 1)); }
inline LoadStep oedometer(double u, double) { return leg_of(stretch(0, 1 - u), stretch(1, 1), stretch(2, 1)); }
inline LoadStep simple_shear(double u, double p) { return leg_of(stretch(0, 1), stress(1, -p), stretch(2, 1), u); }

inline MaterialPoint sand(double void_ratio, double pressure) {
  return {.stress = -pressure * Sym<double>::identity(), .state = {void_ratio, 0.0}};
}
inline std::shared_ptr<const Material> karlsruhe(double tolerance = 1e-6) {
  return material("gudehus_bauer", {{"tolerance", tolerance}});
}
inline bool go_on(const MaterialPoint&) { return true; }

} // namespace riedel::test
