/// What the problems are made of: a block of points on a grid with room around it, rollers, and a watch.
#pragma once

#include "apps/verify/problem.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// A box from the origin, of `cells` cells of size `cell`, with 2 × 2 points in a cell.
struct VerifyBlock {
  Counts<2> cells{};
  double cell = 1.0; ///< [m]
  std::string material;
  std::map<std::string, Value> parameters;
  bool (*holds)(const Vec<2>& x) = nullptr; ///< which points of the box are material; none: all
};

/// State and model before the run starts. Points are numbered as they are placed.
struct VerifySetup {
  Index margin = 0; ///< layers of cells around the box
  Model<2> model;   ///< MUSL, FLIP
  State<2> state;

  [[nodiscard]] Points<2>& points() { return state.bodies.front().points; }
  [[nodiscard]] std::vector<Vec<2>> places() const; ///< X of the points, by their numbers [m]
  /// Holds the velocity across a side of the box, everywhere behind it.
  void add_roller(int axis, bool far_side);
  /// Chooses the time step so that `duration` is a whole number of steps. @return that number
  /// @param speed of the fastest wave [m/s]
  Index divide(double duration, double speed, double cfl);
};

VerifySetup make_setup(const Catalogue& catalogue, const std::string& scheme, const VerifyBlock& block);

/// Steps a simulation and sums up the time it took.
class Watch {
public:
  void step(Simulation<2>& simulation);
  [[nodiscard]] double ns() const { return 1e9 * seconds_ / point_steps_; } ///< per point and step

private:
  double seconds_ = 0.0, point_steps_ = 0.0;
};

/// Relative L2 norm of an error over points, and over time when it is added to step by step.
class ErrorNorm {
public:
  void add(double weight, double difference_squared, double exact_squared) {
    squared_ += weight * difference_squared;
    whole_ += weight * exact_squared;
  }
  [[nodiscard]] double value() const { return std::sqrt(squared_ / whole_); }

private:
  double squared_ = 0.0, whole_ = 0.0;
};

/// Where a point started, the points having been sorted since. @param X by the points' numbers
inline const Vec<2>& start_of(const Points<2>& points, Index p, const std::vector<Vec<2>>& X) {
  return X[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])];
}

/// Adds the error of the points' displacements. @param exact displacement of a point that started at X
template <class Exact>
void add_displacements(ErrorNorm& norm, const Points<2>& points, const std::vector<Vec<2>>& X, const Exact& exact) {
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2>& start = start_of(points, p, X);
    const Vec<2> u = exact(start);
    norm.add(points.initial_volume[0][p], (points.position_of(p) - start - u).squaredNorm(), u.squaredNorm());
  }
}

} // namespace riedel
