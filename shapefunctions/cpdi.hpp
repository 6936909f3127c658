#pragma once

#include "core/interface/shape_function.hpp"

namespace riedel {

/// Convected particle domain interpolation: the hats are interpolated between the corners of a parallelogram
/// (parallelepiped) that deforms with F, and averaged over it.
/// Sadeghirad, Brannon & Burghardt (2011), Int. J. Numer. Meth. Engng 86, 1435–1456.
template <int Dim>
class Cpdi final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "cpdi";

  /// Every corner reaches the nodes of its cell; a node may stand in several corners' entries.
  [[nodiscard]] int max_nodes() const override { return power(4, Dim); }
  [[nodiscard]] int margin() const override { return 3; }
  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override;
  [[nodiscard]] Mat<Dim> domain(const Grid<Dim>& grid, const Points<Dim>& points, Index p) const override;
};

} // namespace riedel
