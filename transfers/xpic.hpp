/// The extended particle-in-cell transfer, XPIC(m): Hammerquist & Nairn (2017), Comput. Methods Appl. Mech. Engrg. 318,
/// 724–738.
#pragma once

#include "transfers/kit/blend.hpp"
#include "transfers/kit/pointwise.hpp"

namespace riedel {

/// FLIP's update after removal of the velocities that the grid does not represent: with S from grid to points and S⁺
/// back, weighted by mass, V ← (I − (I − S S⁺)ᵐ) V + Δt S a; m = 1 is PIC.
template <int Dim>
class Xpic final : public PointwiseTransfer<Dim, Blend<Dim>> {
public:
  static constexpr std::string_view name = "xpic";
  static Keys parameters();
  explicit Xpic(const Values& options);

  [[nodiscard]] int node_records() const override { return 1; }

  void move_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void grid_to_points(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  void remap_velocity(State<Dim>& state, const Model<Dim>& model, double dt) const override;
  [[nodiscard]] std::string damping_text() const override { return VelocityTransfer<Dim>::damping_text(); }

private:
  using Update = PointwiseTransfer<Dim, Blend<Dim>>;
  /// Needs the (mv)_i of the points' velocities, and overwrites them.
  void filter_velocities(State<Dim>& state, const Model<Dim>& model) const;

  int order_; ///< m
};

} // namespace riedel
