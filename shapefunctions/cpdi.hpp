#pragma once

#include "shapefunctions/kit/domain_keys.hpp"

namespace riedel {

/// Convected particle domain interpolation: the hats are interpolated between the corners of a parallelogram
/// (parallelepiped) that deforms with F, and averaged over it.
/// Sadeghirad, Brannon & Burghardt (2011), Int. J. Numer. Meth. Engng 86, 1435–1456. Domains that grow too long can be
/// shortened: Homel, Brannon & Guilkey (2016), Int. J. Numer. Meth. Engng 107, 31–48.
template <int Dim>
class Cpdi final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "cpdi";
  static const Keys& parameters() { return domain_keys(); }

  explicit Cpdi(const Values& options) : limit_(options.number("domain_limit")) {}

  [[nodiscard]] SchemeTraits traits() const override {
    return {.domain = PointDomain::stretched,
            .continuous_gradients = true,
            .order_across_cells = 1,
            .converges_at_free_faces = true,
            .balances_pressure_on_points = true};
  }
  /// Every corner reaches the nodes of its cell; a node may appear in several corners' entries.
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 3; }
  [[nodiscard]] bool traction_at_corners() const override { return true; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
  [[nodiscard]] Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const override;

private:
  double limit_; ///< maximum half diagonal of a domain, in cells; 0: no limit
};

} // namespace riedel
