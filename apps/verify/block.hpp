/// Common setup of the problems: a block of points on a grid with room around it, and rollers.
#pragma once

#include "apps/verify/problem.hpp"
#include "core/step/simulation.hpp"

namespace riedel {

/// A box from the origin, of `cells` cells of size `cell`.
template <int Dim>
struct VerifyBlock {
  Counts<Dim> cells{};
  double cell = 1.0;                  ///< [m]
  int points = 2;                     ///< for a cell along each axis
  Vec<Dim> filled = Vec<Dim>::Ones(); ///< fraction of the box that the points fill, along each axis [-]
  std::string material;
  std::map<std::string, Value> parameters;
  bool (*holds)(const Vec<Dim>& x) = nullptr; ///< which points of the box are material; none: all
};

/// A side of the box.
struct Side {
  int axis = 0;
  bool far = false;
};

/// A field of the points' initial positions, and one that also depends on time.
template <int Dim>
using VectorField = std::function<Vec<Dim>(const Vec<Dim>& X)>;
template <int Dim>
using Course = std::function<Vec<Dim>(const Vec<Dim>& X, double time)>;

/// State and model before the run starts. Points are numbered as they are placed.
template <int Dim>
struct VerifySetup {
  Index margin = 0; ///< layers of cells around the box
  Model<Dim> model; ///< MUSL, FLIP
  State<Dim> state;

  [[nodiscard]] Points<Dim>& points() { return state.bodies.front().points; }
  [[nodiscard]] const Points<Dim>& points() const { return state.bodies.front().points; }
  [[nodiscard]] std::vector<Vec<Dim>> places() const;  ///< X of the points, by their numbers [m]
  void set_velocity(const VectorField<Dim>& velocity); ///< [m/s]
  void add_body_force(const Course<Dim>& per_mass);    ///< [N/kg]
  /// Fixes the velocity normal to a side of the box, everywhere behind it.
  void add_roller(const Side& side);
  /// Chooses the time step so that `duration` is a whole number of steps. @return that number
  /// @param speed of the fastest wave [m/s]
  Index divide(double duration, double speed, double cfl);
};

template <int Dim>
VerifySetup<Dim> make_setup(const VerifyCase& given, const VerifyBlock<Dim>& block);

/// Initial position of a point, also after the points have been sorted. @param X by the points' numbers
template <int Dim>
const Vec<Dim>& start_of(const Points<Dim>& points, Index p, const std::vector<Vec<Dim>>& X) {
  return X[static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)])];
}

} // namespace riedel
