/// Affine transfers: a point carries the velocity gradient about it, so that its nodes receive v_p + C_p (x_i − x_p).
/// They differ in what they store of the gradient, and in the rule by which points take their velocities. Their loops
/// are in affine.ipp, to be included in one source file per transfer.
#pragma once

#include "core/base/pack_matrix.hpp"
#include "core/interface/velocity_transfer.hpp"

namespace riedel {

/// (mv)_i = Σ_p N_ip m_p (v_p + C_p (x_i − x_p)).
/// @tparam Gradient defines what is stored of the gradient: `gather`, from the grid, and `gradient`, C_p from what is
/// stored; see apic.hpp, tpic.hpp
/// @tparam Rule as for PointwiseTransfer
template <int Dim, class Gradient, class Rule>
class AffineTransfer : public VelocityTransfer<Dim> {
public:
  explicit AffineTransfer(Rule rule = {}) : rule_(std::move(rule)) {}

  /// The stored gradient, row by row.
  [[nodiscard]] int point_data_size() const override { return Dim * Dim; }
  /// First moments of the stencils of eight points.
  [[nodiscard]] int thread_data_size(int max_nodes) const override { return max_nodes * Dim * pack_size; }

  void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const override;
  void points_to_grid(State<Dim>& state, const Model<Dim>& model) const override;
  void move_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const override;

protected:
  Rule rule_;
};

} // namespace riedel
