#include "shapefunctions/linear.hpp"

#include "shapefunctions/tensor_product.hpp"

namespace riedel {

namespace {
/// N = 1 − |r|/h at both nodes of the cell.
constexpr auto hats = [](const Pack& s, const Axis& axis) -> std::array<ValueSlope<Pack>, 2> {
  return {{{.value = Pack(1.0) - s, .slope = -axis.per_h}, {.value = s, .slope = axis.per_h}}};
};
} // namespace

template <int Dim>
void Linear<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block,
                           Stencils<Dim>& stencils) const {
  for (Index p = block.begin; p < block.end; p += pack_size) {
    std::array<AxisLanes, Dim> lanes;
    for (int a = 0; a < Dim; ++a)
      lanes[a] = {.position = load_lanes(points.position[a], p, points.size()), .half_width = Pack(0.0)};
    fill_tensor_product<Dim, 2>(grid, lanes, stencils.group_of(p), hats);
  }
}

template <int Dim>
Mat<Dim> Linear<Dim>::domain(const Grid<Dim>&, const Points<Dim>& points, Index p) const {
  // The scheme knows no domain; a box of the point's volume, in the proportions it started with, stands for it.
  Vec<Dim> half;
  for (int a = 0; a < Dim; ++a) half[a] = points.half_size[a][p];
  return (half * std::pow(points.volume[0][p] / points.initial_volume[0][p], 1.0 / Dim)).asDiagonal();
}

template class Linear<2>;
template class Linear<3>;

} // namespace riedel
