/// An absorbing boundary: dashpots that act on waves like a continuation of the material, Lysmer & Kuhlemeyer (1969),
/// J. Eng. Mech. Div. ASCE 95(EM4), 859–877, with a = b = 1.
#include "core/interface/plugin.hpp"
#include "core/step/boundaries/nodewise.hpp"

namespace {

using namespace riedel;

/// Tractions −ρ c_p v_n and −ρ c_s v_t on the outermost row of nodes in its place, times the area A_i that belongs to a
/// node: m_i (v − v_free)/Δt = −ρ c A_i v for each component, which is stable for steps of any size.
template <int Dim>
class Absorbing final : public Nodewise<Absorbing<Dim>, Dim> {
public:
  static constexpr std::string_view kind = "absorbing", summary = "dashpots through which waves leave",
                                    source = "Lysmer & Kuhlemeyer (1969)";
  static Keys parameters() {
    return {{"density", 2000.0, "kg/m3", more_than(0), "of the material beyond the boundary"},
            {"pressure_wave", 400.0, "m/s", more_than(0), "speed c_p of its compression waves"},
            {"shear_wave", 200.0, "m/s", more_than(0), "speed c_s of its shear waves"}};
  }

  Absorbing(const std::string& name, const NodeBox<Dim>& place, const Values& given)
      : Nodewise<Absorbing, Dim>(name, place) {
    resistance_.fill(given.number("density") * given.number("shear_wave"));
    resistance_[place.axis] = given.number("density") * given.number("pressure_wave");
  }

  void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>&) override {
    NodeBox<Dim> row = this->place_; // of the box, the nodes on the boundary itself
    const auto a = static_cast<std::size_t>(row.axis);
    row.first[a] = row.last[a] = row.behind == Behind::lower ? row.last[a] : row.first[a];
    this->take(nodes_in(grid, row));
    areas_.clear();
    for (const Index i : this->nodes()) areas_.push_back(area(grid, row, grid.index(i)));
  }

  Vec<Dim> velocity(const FreeNode<Dim>& node) const {
    Vec<Dim> v = node.velocity;
    if (node.mass > 0.0)
      for (int a = 0; a < Dim; ++a) v[a] /= 1.0 + resistance_[a] * areas_[node.k] * node.dt / node.mass;
    return v;
  }
  Vec<Dim> velocity_alone(const FreeNode<Dim>& node) const { return node.velocity; } // no force, no change
  Vec<Dim> motion(double) const { return Vec<Dim>::Zero(); }

private:
  /// Of the boundary around a node, half of it at the ends of the row [m² or m].
  static double area(const Grid<Dim>& grid, const NodeBox<Dim>& row, const Counts<Dim>& index) {
    double product = 1.0;
    for (std::size_t b = 0; b < Dim; ++b) {
      if (static_cast<int>(b) == row.axis) continue;
      product *= grid.cell[b] * (0.5 * (index[b] > row.first[b]) + 0.5 * (index[b] < row.last[b]));
    }
    return product;
  }

  std::array<double, Dim> resistance_; ///< ρ c along each axis [Pa s/m]
  std::vector<double> areas_;          ///< A_i by node [m² or m]
};

} // namespace

RIEDEL_PLUGIN(riedel::boundary_condition<Absorbing>)
