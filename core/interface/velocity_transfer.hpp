/// A transfer: how velocities get from points to the grid and back.
#pragma once

#include "core/base/registry.hpp"
#include "core/state/nodes.hpp"
#include "core/state/points.hpp"

namespace riedel {

template <int Dim>
struct Model;
template <int Dim>
struct State;

/// What a transfer promises and what it needs. The tests hold every registered transfer to it; cases are checked by it.
struct TransferTraits {
  /// Whether the scheme must give each point weight on both sides of it along every axis (`supports_affine`): that does
  /// not matter, or a case is warned, or refused.
  enum class Spread { any, wanted, needed };

  bool musl = true, usl = true, usf = true; ///< the orders of the step with which it goes
  Spread spread = Spread::any;
  bool keeps_angular_momentum = false; ///< of x_p × v_p and `velocity_moment` together; all keep linear momentum

  [[nodiscard]] bool goes_with(std::string_view order) const {
    return order == "musl" ? musl : order == "usl" ? usl : order == "usf" ? usf : true;
  }
};

/// Working space within a step, as much as the transfer asks for. The library makes it and does not know what it means.
template <int Dim>
struct TransferRoom {
  std::vector<AlignedVector<NodeMotion<Dim>>> nodes; ///< `node_records` times a record for each node
  std::vector<AlignedVector<double>> threads;        ///< `thread_data_size` numbers for each thread

  [[nodiscard]] double* of_this_thread() { return threads[static_cast<std::size_t>(this_thread())].data(); }
};

/// Contract, tested for every registered transfer: mass and linear momentum are kept, a uniform velocity stays as it
/// is, no motion gains energy, and the bits are the same for any number of threads. There is one call for a pass over
/// the points; inside it run plain loops without allocation, lock or throw. Loops, and transfers that are a formula for
/// eight points, are in transfers/kit.
///
/// A parameter in 1/s that a case may leave at "auto" is a rate of damping: the case puts the rate at which waves cross
/// the specimen in its place.
template <int Dim>
class VelocityTransfer {
public:
  virtual ~VelocityTransfer() = default;
  VelocityTransfer() = default;
  VelocityTransfer(const VelocityTransfer&) = delete;
  VelocityTransfer& operator=(const VelocityTransfer&) = delete;

  [[nodiscard]] virtual TransferTraits traits() const { return {}; }

  /// Numbers kept for each point from step to step, in `points.transfer_data`, 0 at the start: the library makes room
  /// for them and carries them with the points.
  [[nodiscard]] virtual int point_data_size() const { return 0; }
  /// Records, two vectors each, for which a step needs room at every node, in `state.transfer_room.nodes`.
  [[nodiscard]] virtual int node_records() const { return 0; }
  /// Numbers for which each thread needs room, in `state.transfer_room.threads`.
  /// @param max_nodes most entries of a stencil
  [[nodiscard]] virtual int thread_data_size(int /*max_nodes*/) const { return 0; }

  /// Sums from zero m_i = Σ_p N_ip m_p and (mv)_i, for vanishing point data Σ_p N_ip m_p v_p.
  virtual void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const = 0;
  /// The same and, in the same sweep, f_i = −Σ_p V_p (σ_p + p I) ∇N_ip.
  virtual void points_to_grid(State<Dim>& state, const Model<Dim>& model) const = 0;

  /// v_p and x_p, from v_i and a_i of the momentum balance: USF.
  virtual void move_points(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;
  /// The same and, in the same sweep, L_p = Σ_i v_i ⊗ ∇N_ip with F_p and V_p: USL.
  virtual void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;
  /// v_p, while x_p stays where it is and its way is left in `body.way`; and back to the grid, (mv)_i of the new v_p:
  /// the M of MUSL.
  virtual void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;

  /// B_p, the part of Σ_i N_ip v_i ⊗ (x_i − x_p) that the point keeps beside v_p [m²/s]: it turns with its axial
  /// vector.
  [[nodiscard]] virtual Mat<Dim> velocity_moment(const Points<Dim>&, Index /*p*/) const { return Mat<Dim>::Zero(); }
  /// How fast it lets motion fade that the grid does not see, in a few words.
  [[nodiscard]] virtual std::string damping_text() const { return "none by FLIP and PIC"; }
};

/// @param options the section `time` of a case, as far as the transfer has declared it
template <int Dim>
using VelocityTransfers = Registry<std::unique_ptr<VelocityTransfer<Dim>>(const Values& options)>;

/// The one in force where none is named: the first that is registered, with its defaults.
template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> default_transfer();

} // namespace riedel
