#pragma once

#include "shapefunctions/kit/domain_keys.hpp"

namespace riedel {

/// Second-order convected particle domain interpolation: as in `Cpdi`, but the domain is a quadrilateral (hexahedron)
/// whose corners move individually with the velocity of the grid, so that neighbours' domains stay joined. A point is
/// at the centroid of its domain. Sadeghirad, Brannon & Guilkey (2013), Int. J. Numer. Meth. Engng 95, 928–952. Limit
/// as in `Cpdi`.
template <int Dim>
class Cpdi2 final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "cpdi2";
  static const Keys& parameters() { return domain_keys(); }

  explicit Cpdi2(const Values& options) : limit_(options.number("domain_limit")) {}

  [[nodiscard]] SchemeTraits traits() const override {
    return {.domain = PointDomain::stretched,
            .continuous_gradients = true,
            .order_across_cells = 1,
            .converges_at_free_faces = true,
            .balances_pressure_on_points = true,
            .moves_points = true};
  }
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 3; }
  [[nodiscard]] bool traction_at_corners() const override { return true; }
  /// Coordinate a of corner c [m] is in column c Dim + a.
  [[nodiscard]] int point_data_size() const override { return power(2, Dim) * Dim; }
  void initialise(const Grid<Dim>& grid, Points<Dim>& points) const override;
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
  void move(const Grid<Dim>& grid, const Nodes<Dim>& nodes, double dt, Points<Dim>& points, Range block) const override;
  [[nodiscard]] Corners<Dim> corners(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const override;

private:
  double limit_; ///< maximum distance of a corner from the point, in cells; 0: no limit
};

} // namespace riedel
