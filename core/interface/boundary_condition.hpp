/// What holds, drives or rubs nodes of the grid: from the motion that the momentum balance gives them to the motion
/// that a boundary allows, and the force that this takes.
#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// The nodes in the middle of a step.
template <int Dim>
struct BoundaryStep {
  const Grid<Dim>& grid;
  Nodes<Dim>& nodes; ///< masses, velocities and accelerations; these two are to be changed together
  NodePower& power;  ///< of all forces on the nodes; a condition adds that of its own
  double time = 0.0; ///< at the end of the step [s]
  double dt = 0.0;   ///< [s]
};

/// What a condition did in the last step. work = reaction · speed · Δt − dissipated.
template <int Dim>
struct BoundaryReport {
  double speed = 0.0;                ///< the boundary's velocity along its own direction [m/s]
  double reaction = 0.0;             ///< force on the material that does work with this speed [N or N/m]
  Vec<Dim> force = Vec<Dim>::Zero(); ///< Σ_i m_i Δv_i/Δt, all that the material felt [N or N/m]
  double work = 0.0;                 ///< done on the material [J or J/m]
  double dissipated = 0.0;           ///< lost between boundary and material: friction, a dashpot [J or J/m]
};

/// On which side of a wall there is no material.
enum class Behind { lower, upper };

/// A box of nodes, and the axis across which a condition acts there.
template <int Dim>
struct NodeBox {
  Counts<Dim> first{}, last{}; ///< corners, both included
  int axis = 0;
  Behind behind = Behind::lower;
};

/// Contract, tested for every registered condition in two and three dimensions: force · Δt = Σ m_i Δv_i; the account
/// given in `BoundaryReport`; velocities alone set twice are those set once; what is at rest against a boundary at rest
/// stays so; no allocation in a step, and sums in the order of the nodes, whatever the number of threads.
/// One object serves one simulation.
template <int Dim>
class BoundaryCondition {
public:
  explicit BoundaryCondition(std::string name) : name_(std::move(name)) {}
  virtual ~BoundaryCondition() = default;
  BoundaryCondition(const BoundaryCondition&) = delete;
  BoundaryCondition& operator=(const BoundaryCondition&) = delete;

  /// Given by the user.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The nodes it acts on now, each once.
  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }
  [[nodiscard]] const BoundaryReport<Dim>& report() const { return report_; }

  /// Before the first step: finds its nodes, and takes all the memory that it will need. Throws InputError.
  virtual void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) = 0;
  /// Rows of nodes that are walls to schemes whose functions end there; asked for once, after `bind`.
  [[nodiscard]] virtual std::array<Walls, Dim> walls(const Grid<Dim>& /*grid*/) const { return {}; }
  /// At the start of a step: finds the nodes anew, if they change. Throws RunError.
  virtual void follow(const Grid<Dim>&, const ShapeFunction<Dim>&) {}
  /// Nodes have the velocities that the last strains came from, for the last time.
  virtual void remember(const Nodes<Dim>&) {}
  /// After the momentum balance: sets velocities, Δv/Δt of accelerations, and makes the report.
  virtual void apply(BoundaryStep<Dim>& step) = 0;
  /// After a remap, or before the strains of USF: sets velocities alone. `power.end` gains m_i a_i · Δv_i.
  virtual void apply_velocities(BoundaryStep<Dim>& step) = 0;
  /// What it consists of, for files and pictures; null: of no points.
  [[nodiscard]] virtual const Points<Dim>* points() const { return nullptr; }
  /// At the end of a step: moves what it consists of.
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
