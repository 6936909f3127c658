/// A transfer: maps velocities from points to the grid and back.
#pragma once

#include "core/base/registry.hpp"
#include "core/state/nodes.hpp"
#include "core/state/points.hpp"

namespace riedel {

template <int Dim>
struct Model;
template <int Dim>
struct State;

/// Properties and requirements of a transfer. Tests check them for every registered transfer, and cases against them.
struct TransferTraits {
  /// Whether the scheme must give each point weight on both sides of it along every axis (`supports_affine`): not
  /// needed, advisable (a case gets a warning), or required (a case is refused).
  enum class Spread { any, wanted, needed };

  bool musl = true, usl = true, usf = true; ///< orders of the step with which it can be combined
  Spread spread = Spread::any;
  bool keeps_angular_momentum = false; ///< conserves x_p × v_p plus `velocity_moment`; all conserve linear momentum

  [[nodiscard]] bool goes_with(std::string_view order) const {
    return order == "musl" ? musl : order == "usl" ? usl : order == "usf" ? usf : true;
  }
};

/// Working space within a step, as much as the transfer requests. The library allocates it without interpreting it.
template <int Dim>
struct TransferRoom {
  std::vector<AlignedVector<NodeMotion<Dim>>> nodes; ///< `node_records` times one record per node
  std::vector<AlignedVector<double>> threads;        ///< `thread_data_size` numbers per thread

  [[nodiscard]] double* of_this_thread() { return threads[static_cast<std::size_t>(this_thread())].data(); }
};

/// Contract, tested for every registered transfer: mass and linear momentum are conserved, a uniform velocity is
/// unchanged, no motion gains energy, and results are identical to the bit for any number of threads. Each pass over
/// the points is one call; it contains plain loops without allocation, lock or throw. Loops, and transfers that are a
/// formula for eight points, are in transfers/kit.
///
/// A parameter in 1/s that a case may leave at "auto" is a damping rate: the case substitutes the rate at which waves
/// cross the specimen.
template <int Dim>
class VelocityTransfer {
public:
  virtual ~VelocityTransfer() = default;
  VelocityTransfer() = default;
  VelocityTransfer(const VelocityTransfer&) = delete;
  VelocityTransfer& operator=(const VelocityTransfer&) = delete;

  [[nodiscard]] virtual TransferTraits traits() const { return {}; }

  /// Numbers stored for each point from step to step, in `points.transfer_data`, initially 0: the library allocates
  /// them and keeps them with the points.
  [[nodiscard]] virtual int point_data_size() const { return 0; }
  /// Number of records, two vectors each, that a step needs at every node, in `state.transfer_room.nodes`.
  [[nodiscard]] virtual int node_records() const { return 0; }
  /// Numbers that each thread needs, in `state.transfer_room.threads`.
  /// @param max_nodes maximum number of entries in a stencil
  [[nodiscard]] virtual int thread_data_size(int /*max_nodes*/) const { return 0; }

  /// Computes from zero m_i = Σ_p N_ip m_p and (mv)_i, for vanishing point data Σ_p N_ip m_p v_p.
  virtual void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const = 0;
  /// The same and, in the same pass, f_i = −Σ_p V_p (σ_p + p I) ∇N_ip.
  virtual void points_to_grid(State<Dim>& state, const Model<Dim>& model) const = 0;

  /// v_p and x_p, from v_i and a_i of the momentum balance: USF.
  virtual void move_points(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;
  /// The same and, in the same pass, L_p = Σ_i v_i ⊗ ∇N_ip with F_p and V_p: USL.
  virtual void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;
  /// v_p, while x_p is unchanged and its displacement is left in `body.displacement_increment`; then back to the grid,
  /// (mv)_i of the new v_p: the M of MUSL.
  virtual void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const = 0;

  /// B_p, the part of Σ_i N_ip v_i ⊗ (x_i − x_p) that the point keeps in addition to v_p [m²/s]: its axial vector
  /// contributes angular momentum.
  [[nodiscard]] virtual Mat<Dim> velocity_moment(const Points<Dim>&, Index /*p*/) const { return Mat<Dim>::Zero(); }
  /// In a few words, how fast it damps motion that the grid does not represent.
  [[nodiscard]] virtual std::string damping_text() const { return "none by FLIP and PIC"; }
};

/// @param options the section `time` of a case, as declared by the transfer
template <int Dim>
using VelocityTransfers = Registry<std::unique_ptr<VelocityTransfer<Dim>>(const Values& options)>;

/// The default transfer: the first that is registered, with its defaults.
template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> default_transfer();

} // namespace riedel
