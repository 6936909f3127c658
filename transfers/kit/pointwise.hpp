/// Transfers without a gradient: a point gives its nodes N_ip m_p v_p, and takes its new velocity by a rule for eight
/// points. Their loops are in pointwise.ipp, to be included in one source file per transfer.
#pragma once

#include "core/interface/velocity_transfer.hpp"

namespace riedel {

/// @tparam Rule has `over(dt)`, called once per pass, which returns a function that maps the gathered values of eight
/// points and the points, p the first, to their NewMotion<Dim>: see blend.hpp
template <int Dim, class Rule>
class PointwiseTransfer : public VelocityTransfer<Dim> {
public:
  explicit PointwiseTransfer(Rule rule = {}) : rule_(std::move(rule)) {}

  void map_mass_and_momentum(State<Dim>& state, const Model<Dim>& model) const override;
  void points_to_grid(State<Dim>& state, const Model<Dim>& model) const override;
  void move_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const override;

protected:
  Rule rule_;
};

} // namespace riedel
