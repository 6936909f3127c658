#include "core/io/snapshot.hpp"

#include "core/base/tensor.hpp"

#include <cmath>

namespace riedel {

namespace {

/// Adds fields of a body's points, reading them in the order of their ids.
template <int Dim>
class FieldList {
public:
  FieldList(const Points<Dim>& points, std::vector<Field>& fields) : points_(points), fields_(fields) {}

  template <class Value>
  void add(const std::string& name, int components, const std::string& unit, const Value& value) {
    Field field{.name = name, .components = components, .unit = unit, .values = {}};
    field.values.reserve(points_.place.size() * static_cast<std::size_t>(components));
    for (const Index p : points_.place)
      for (int c = 0; c < components; ++c) field.values.push_back(value(p, c));
    fields_.push_back(std::move(field));
  }
  void add(const std::string& name, const std::string& unit, const Columns& columns, int first = 0, int count = 1) {
    add(name, count, unit, [&](Index p, int c) { return columns[first + c][p]; });
  }

private:
  const Points<Dim>& points_;
  std::vector<Field>& fields_;
};

/// Tensors as six components xx, yy, zz, xy, yz, xz: ParaView's order.
double tensor_component(const Columns& mandel, int first, Index p, int c) {
  constexpr std::array<int, 6> from{0, 1, 2, 3, 5, 4};
  const double value = mandel[first + from[static_cast<std::size_t>(c)]][p];
  return c < 3 ? value : value * std::numbers::sqrt2 / 2;
}

/// The unit of the scalar that a body averages: ‖D‖, or one of its law's state variables.
template <int Dim>
std::string averaged_unit(const Body<Dim>& body) {
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    if (column == body.averaged_state) return variable.unit;
    column += variable.components;
  }
  return "1/s";
}

template <int Dim>
double polar_rotation(const Mat<Dim>& F) {
  return std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1)) * 180.0 / std::numbers::pi;
}

template <int Dim>
void add_fields(const Body<Dim>& body, std::vector<Field>& fields) {
  const Points<Dim>& points = body.points;
  FieldList<Dim> list(points, fields);
  list.add("id", 1, "-", [&](Index p, int) { return points.id[static_cast<std::size_t>(p)]; });
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    const int first = column;
    if (variable.components == 6)
      list.add(variable.name, 6, variable.unit,
               [&](Index p, int c) { return tensor_component(points.state, first, p, c); });
    else
      list.add(variable.name, variable.unit, points.state, first, variable.components);
    column += variable.components;
  }
  list.add("shear_strain", "-", points.shear_strain);
  list.add("stress", 6, "Pa", [&](Index p, int c) { return tensor_component(points.stress, 0, p, c); });
  list.add("mean_pressure", 1, "Pa",
           [&](Index p, int) { return -(points.stress[0][p] + points.stress[1][p] + points.stress[2][p]) / 3.0; });
  list.add("rate_norm", "1/s", points.rate_norm);
  if (body.averager) list.add("averaged", averaged_unit(body), points.averaged);
  list.add("velocity", 3, "m/s", [&](Index p, int c) { return c < Dim ? points.velocity[c][p] : 0.0; });
  list.add("volume", Dim == 2 ? "m2" : "m3", points.volume);
  list.add("mass", Dim == 2 ? "kg/m" : "kg", points.mass);
  list.add("volume_ratio", 1, "-", [&](Index p, int) { return points.volume[0][p] / points.initial_volume[0][p]; });
  list.add("polar_rotation", 1, "deg",
           [&](Index p, int) { return polar_rotation<Dim>(points.deformation_gradient_of(p)); });
}

/// Corners in VTK's order: counter-clockwise, the lower face first.
template <int Dim>
void add_corners(const Corners<Dim>& of_domain, std::vector<double>& corners) {
  constexpr std::array<std::size_t, 8> order{0, 1, 3, 2, 4, 5, 7, 6};
  for (std::size_t c = 0; c < of_domain.size(); ++c)
    for (int a = 0; a < 3; ++a) corners.push_back(a < Dim ? of_domain[order[c]][a] : 0.0);
}

} // namespace

template <int Dim>
Frame snapshot(const Simulation<Dim>& simulation, double u_over_h) {
  const State<Dim>& state = simulation.state();
  Frame frame{.dimension = Dim, .time = state.time, .u_over_h = u_over_h, .position = {}, .corners = {}, .fields = {}};
  const Body<Dim>& body = state.bodies.front();
  for (const Index p : body.points.place) {
    const Vec<Dim> x = body.points.position_of(p);
    for (int a = 0; a < 3; ++a) frame.position.push_back(a < Dim ? x[a] : 0.0);
    add_corners<Dim>(simulation.model().scheme->corners(state.grid, body.points, p), frame.corners);
  }
  add_fields(body, frame.fields);
  return frame;
}

template Frame snapshot<2>(const Simulation<2>&, double);
template Frame snapshot<3>(const Simulation<3>&, double);

} // namespace riedel
