/// A scheme: hats averaged over a box of a given width, whatever the size of the points.
#include "core/interface/plugin.hpp"
#include "shapefunctions/kit/tensor_product.hpp"

namespace {

using namespace riedel;

template <int Dim>
class Boxed final : public ShapeFunction<Dim> {
public:
  static constexpr std::string_view name = "boxed", summary = "hats averaged over a box of any width";
  static Keys parameters() { return {{"width", 0.5, "-", within(0, 1), "boxed: width of the box, in cells"}}; }
  explicit Boxed(const Values& given) : width_(given.number("width")) {}

  [[nodiscard]] SchemeTraits traits() const override { return {.continuous_gradients = true, .order_across_cells = 1}; }
  [[nodiscard]] int max_nodes() const override { return power(3, Dim); } // three along each axis
  [[nodiscard]] int margin() const override { return 1; }                // a box reaches over its cell's edge

  void evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const override {
    for (Index p = block.begin; p < block.end; p += pack_size) { // eight points at a time
      std::array<AxisLanes, Dim> lanes;
      for (int a = 0; a < Dim; ++a)
        lanes[a] = {.position = load_lanes(points.position[a], p, points.size()),
                    .half_width = Pack(0.5 * width_ * grid.cell[a])};
      fill_tensor_product<Dim, 3>(grid, lanes, stencils.group_of(p), three_factors);
    }
  }

private:
  /// [B(r + l) − B(r − l)]/2l and its gradient, with B the integral of the hat from 0.
  static std::array<ValueGradient<Pack>, 3> three_factors(const Pack& s, const Axis& axis) {
    return at_each_node<3>(s, axis, [](const Pack& r, const Axis& a) {
      const auto hat = [&](const Pack& x) { return max(Pack(1.0) - abs(x) * a.per_h, Pack(0.0)); };
      const auto integral = [&](const Pack& x) {
        const Pack c = max(-a.h, min(x, a.h));
        return c - c * abs(c) * (Pack(0.5) * a.per_h);
      };
      return ValueGradient<Pack>{.value = (integral(r + a.l) - integral(r - a.l)) * a.per_2l,
                                 .gradient = (hat(r + a.l) - hat(r - a.l)) * a.per_2l};
    });
  }

  double width_; ///< in cells [-]
};

} // namespace

RIEDEL_PLUGIN(riedel::scheme<Boxed>)
