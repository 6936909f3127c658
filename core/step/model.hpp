/// Everything that does not change in a run.
#pragma once

#include "core/interface/boundary_condition.hpp"
#include "core/interface/velocity_transfer.hpp"
#include "core/step/state.hpp"

#include <optional>

namespace riedel {

/// One time step: usf_step, usl_step or musl_step.
template <int Dim>
using StepFunction = void (*)(State<Dim>& state, const Model<Dim>& model, double dt);

/// The spin that rotates stress and tensor state: W, or that of R in F = R U.
enum class ObjectiveRate { jaumann, green_naghdi };

/// The remedy for locking of nearly incompressible material: none, or the mean dilatation of a cell.
enum class Locking { none, f_bar };

/// Lets null-space modes of the points' stresses decay, and slowly those of their volumes. See
/// docs/theory/stress_filter.md.
struct StressFilter {
  double stress_rate = 0.0; ///< decay rate λ of such stresses [1/s]
  double volume_rate = 0.0; ///< decay rate λ_J of such parts of ln J [1/s]
  int order = 12;           ///< m of (I − S)^m: the larger, the shorter the waves that decay
  int volume_axes = 3;      ///< number of axes that share what is added to tr L: two in a slab between walls
  int steps_between = 20;   ///< k: filtered in every k-th step, with the effect of k steps

  [[nodiscard]] bool on() const { return stress_rate > 0.0 || volume_rate > 0.0; }
};

/// A grid that follows a platen: along `axis` its cells stretch so that node row `moving_row` stays on the platen,
/// while `fixed_row` does not move.
struct MovingGrid {
  int axis = 1;
  Index fixed_row = 0, moving_row = 0;
  std::string platen; ///< name of the condition whose speed it follows
};

/// A traction on surface points: on each outer face, at its present position and orientation.
template <int Dim>
struct SurfaceTraction {
  /// [Pa], on the present surface, from the position [m], the outward normal and the time [s]
  std::function<Vec<Dim>(const Vec<Dim>& place, const Vec<Dim>& normal, double time)> value;
  std::size_t body = 0;
  std::vector<Vec<Dim>> initial_area; ///< outward, along an axis, by point id; zero off the surface [m² or m]
};

/// A uniform pressure, compressive if positive [Pa].
template <int Dim>
auto uniform_pressure(double pressure) {
  return [pressure](const Vec<Dim>&, const Vec<Dim>& normal, double) -> Vec<Dim> { return -pressure * normal; };
}

/// A force, as a function of position and time, on all points of a body, in addition to gravity.
template <int Dim>
struct BodyForce {
  std::size_t body = 0;
  /// [N/kg] of point p at the start of a step; called by several threads at once
  std::function<Vec<Dim>(const Points<Dim>& points, Index p, double time)> per_mass;
};

template <int Dim>
struct Model {
  std::shared_ptr<const ShapeFunction<Dim>> scheme;
  StepFunction<Dim> step = nullptr;
  ObjectiveRate objective_rate = ObjectiveRate::jaumann;
  std::vector<Boundary<Dim>> conditions; ///< they act in this order
  std::vector<MovingGrid> moving_grids;  ///< at most one per axis
  Vec<Dim> gravity = Vec<Dim>::Zero();   ///< [m/s²]
  double confining_pressure = 0.0;       ///< p of the virtual stress −p I that acts outside the bodies [Pa]
  std::vector<SurfaceTraction<Dim>> surface_tractions;
  std::vector<BodyForce<Dim>> body_forces;
  std::optional<bool> keep_stencils; ///< of all points for a step, or block by block; empty: whichever is faster
  std::shared_ptr<const VelocityTransfer<Dim>> transfer = default_transfer<Dim>();
  Locking locking = Locking::none;
  StressFilter stress_filter;
  double cfl = 0.5;             ///< share of the stable time step taken [-]
  double fixed_time_step = 0.0; ///< [s]; 0: from the law's wave speed
};

} // namespace riedel
