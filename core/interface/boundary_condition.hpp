/// Conditions that fix, drive or rub nodes of the grid: they turn the motion from the momentum balance into the motion
/// that the boundary allows, and give the force that this requires.
#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// The nodes during a step.
template <int Dim>
struct BoundaryStep {
  const Grid<Dim>& grid;
  Nodes<Dim>& nodes; ///< masses, velocities and accelerations; change the last two together
  NodePower& power;  ///< of all forces on the nodes; a condition adds that of its own force
  double time = 0.0; ///< at the end of the step [s]
  double dt = 0.0;   ///< [s]
};

/// What a condition did in the last step; work = reaction · speed · Δt − dissipated.
template <int Dim>
struct BoundaryReport {
  double speed = 0.0;                ///< the boundary's velocity along its direction [m/s]
  double reaction = 0.0;             ///< force on the material, conjugate to this speed [N or N/m]
  Vec<Dim> force = Vec<Dim>::Zero(); ///< Σ_i m_i Δv_i/Δt, the total on the material [N or N/m]
  double work = 0.0;                 ///< done on the material [J or J/m]
  double dissipated = 0.0;           ///< dissipated between boundary and material: friction, a dashpot [J or J/m]
};

/// The side of a wall without material.
enum class Behind { lower, upper };

/// A box of nodes, and the axis across which a condition acts there.
template <int Dim>
struct NodeBox {
  Counts<Dim> first{}, last{}; ///< corners, both included
  int axis = 0;
  Behind behind = Behind::lower;
};

/// Contract, tested for every registered condition in two and three dimensions: force · Δt = Σ m_i Δv_i; the energy
/// balance given in `BoundaryReport`; setting velocities alone twice equals setting them once; material at rest against
/// a boundary at rest stays at rest; no allocation in a step, and sums in the order of the nodes, whatever the number
/// of threads. One object serves one simulation.
template <int Dim>
class BoundaryCondition {
public:
  explicit BoundaryCondition(std::string name) : name_(std::move(name)) {}
  virtual ~BoundaryCondition() = default;
  BoundaryCondition(const BoundaryCondition&) = delete;
  BoundaryCondition& operator=(const BoundaryCondition&) = delete;

  /// Given by the user.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The nodes on which it acts now, each once.
  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }
  [[nodiscard]] const BoundaryReport<Dim>& report() const { return report_; }

  /// Before the first step: finds its nodes, and allocates all its memory. Throws InputError.
  virtual void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) = 0;
  /// Rows of nodes that are walls to schemes whose functions end there; called once, after `bind`.
  [[nodiscard]] virtual std::array<Walls, Dim> walls(const Grid<Dim>& /*grid*/) const { return {}; }
  /// At the start of a step: finds the nodes again, if they change. Throws RunError.
  virtual void follow(const Grid<Dim>&, const ShapeFunction<Dim>&) {}
  /// Called for the last time with the nodal velocities from which the last strains were computed.
  virtual void remember(const Nodes<Dim>&) {}
  /// After the momentum balance: sets velocities, adds Δv/Δt to accelerations, and fills the report.
  virtual void apply(BoundaryStep<Dim>& step) = 0;
  /// After a remap, or before the strains of USF: sets velocities only. `power.end` gains m_i a_i · Δv_i.
  virtual void apply_velocities(BoundaryStep<Dim>& step) = 0;
  /// The points it consists of, for files and pictures; null if there are none.
  [[nodiscard]] virtual const Points<Dim>* points() const { return nullptr; }
  /// At the end of a step: moves its own parts.
  virtual void move(double /*time*/, double /*dt*/) {}

protected:
  std::vector<Index> nodes_;
  BoundaryReport<Dim> report_;

private:
  std::string name_;
};

template <int Dim>
using Boundary = std::unique_ptr<BoundaryCondition<Dim>>;

/// @param name given by the user   @param place where it acts   @param values of its parameters
template <int Dim>
using BoundaryConditions =
    Registry<Boundary<Dim>(const std::string& name, const NodeBox<Dim>& place, const Values& values)>;

} // namespace riedel
