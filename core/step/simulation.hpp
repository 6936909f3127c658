/// A run: state and model, advanced step by step.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Energies at one instant [J, or J/m in plane strain].
struct Energies {
  double kinetic = 0.0;
  double internal = 0.0; ///< work of the stresses since the start
  double external = 0.0; ///< work of boundaries, gravity, confining pressure and surface loads since the start
  /// Dissipated between boundaries and material since the start: friction, dashpots.
  double dissipated = 0.0;
  double transfer = 0.0;    ///< work of nodal forces that did not become motion of the points: damping, loss
  double filter = 0.0;      ///< internal work by the stress filter's strains, not by forces
  double unaccounted = 0.0; ///< external + filter − internal − transfer − gain of kinetic energy
};

template <int Dim>
class Simulation {
public:
  /// Binds conditions to nodes, sorts the points, and computes the first time step. Throws InputError, also for points
  /// outside the grid, or RunError.
  Simulation(Model<Dim> model, State<Dim> state);

  /// One step. Throws RunError; the state is then that at the failure, valid for a report only.
  void step();

  [[nodiscard]] const State<Dim>& state() const { return state_; }
  [[nodiscard]] State<Dim>& state() { return state_; }
  [[nodiscard]] const Model<Dim>& model() const { return model_; }
  [[nodiscard]] double time_step() const { return time_step_; }
  /// min(h)/(c + |v|): the time step in which a wave, or a point, crosses a cell [s].
  [[nodiscard]] double crossing_time() const { return crossing_time_; }
  [[nodiscard]] std::int64_t out_of_bounds() const {
    return out_of_bounds_;
  } ///< maximum number of points at once so far
  [[nodiscard]] Energies energies() const;
  /// The boundary condition called `name`. Throws std::out_of_range.
  [[nodiscard]] const BoundaryCondition<Dim>& boundary(std::string_view name) const;
  /// Its velocity, and the force in the last step.
  [[nodiscard]] const BoundaryReport<Dim>& boundary_report(std::string_view name) const {
    return boundary(name).report();
  }

private:
  void assess_bodies();
  void follow_platens(double dt);
  [[nodiscard]] double potential_of_loads() const;
  [[nodiscard]] double kinetic_energy() const;

  Model<Dim> model_;
  State<Dim> state_;
  double time_step_ = 0.0, crossing_time_ = 0.0, potential_at_start_ = 0.0, kinetic_at_start_ = 0.0;
  std::int64_t out_of_bounds_ = 0;
  std::vector<MaterialLimits> limits_; ///< working space
};

} // namespace riedel
