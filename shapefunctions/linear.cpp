#include "shapefunctions/linear.hpp"

#include "shapefunctions/kit/tensor_product.hpp"

namespace riedel {

namespace {
/// N = 1 − |r|/h at both nodes of the cell.
constexpr auto hats = [](const Pack& s, const Axis& axis) -> std::array<ValueGradient<Pack>, 2> {
  return {{{.value = Pack(1.0) - s, .gradient = -axis.per_h}, {.value = s, .gradient = axis.per_h}}};
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

template class Linear<2>;
template class Linear<3>;

} // namespace riedel
