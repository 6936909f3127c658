#include "core/io/snapshot.hpp"

#include "core/base/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riedel {

namespace {

/// Adds the fields of one body after another, deformable or rigid, with its points in the order of their ids.
template <int Dim>
class FieldList {
public:
  /// @param before number of points in the previous bodies
  FieldList(const Points<Dim>& points, const std::string& body, std::size_t before, std::vector<Field>& fields)
      : points_(points), body_(body), before_(before), fields_(fields) {}

  template <class Value>
  Field& add(const std::string& name, int components, const std::string& unit, const Value& value) {
    Field& field = field_of(name, components, unit);
    for (const Index p : points_.place)
      for (int c = 0; c < components; ++c) field.values.push_back(value(p, c));
    return field;
  }
  void add(const std::string& name, const std::string& unit, const Columns& columns, int first = 0, int count = 1) {
    add(name, count, unit, [&](Index p, int c) { return columns[first + c][p]; });
  }
  /// Fields that only other bodies have are NaN here.
  void fill_gaps() {
    for (Field& field : fields_) fill(field, before_ + points_.place.size());
  }

private:
  static void fill(Field& field, std::size_t points) {
    field.values.resize(points * static_cast<std::size_t>(field.components), std::numeric_limits<double>::quiet_NaN());
  }
  /// Two laws may use one name with different meanings; the later one is then followed by its body's name.
  Field& field_of(const std::string& name, int components, const std::string& unit) {
    const auto known = std::ranges::find(fields_, name, &Field::name);
    if (known != fields_.end() && known->components == components && known->unit == unit) return *known;
    if (known != fields_.end()) return field_of(name + "_" + body_, components, unit);
    fields_.push_back({.name = name, .components = components, .unit = unit, .values = {}});
    fill(fields_.back(), before_);
    return fields_.back();
  }

  const Points<Dim>& points_;
  const std::string& body_;
  std::size_t before_;
  std::vector<Field>& fields_;
};

/// Tensors as six components xx, yy, zz, xy, yz, xz: ParaView's order.
double tensor_component(const Columns& mandel, int first, Index p, int c) {
  constexpr std::array<int, 6> from{0, 1, 2, 3, 5, 4};
  const double value = mandel[first + from[static_cast<std::size_t>(c)]][p];
  return c < 3 ? value : value * std::numbers::sqrt2 / 2;
}

/// The unit of the scalar averaged in a body: ‖D‖, or one of its law's state variables.
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

/// √(3/2) ‖s‖ [Pa]
double von_mises(const Columns& stress, Index p) {
  Sym<double> sigma{};
  for (int c = 0; c < 6; ++c) sigma.m[static_cast<std::size_t>(c)] = stress[c][p];
  return std::sqrt(1.5) * norm(deviator(sigma));
}

/// Component of a 3 × 3 tensor, row by row; there is no deformation out of the plane.
template <int Dim>
double component_of(const Columns& tensor, Index p, int c) {
  const int i = c / 3, j = c % 3;
  if (i < Dim && j < Dim) return tensor[i * Dim + j][p];
  return i == j ? 1.0 : 0.0;
}

template <int Dim>
void add_state(const Body<Dim>& body, FieldList<Dim>& list) {
  const Columns& state = body.points.state;
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    const int first = column;
    if (variable.components == 6)
      list.add(variable.name, 6, variable.unit, [&](Index p, int c) { return tensor_component(state, first, p, c); });
    else
      list.add(variable.name, variable.unit, state, first, variable.components);
    column += variable.components;
  }
}

template <int Dim>
void add_stress_and_rates(const Body<Dim>& body, FieldList<Dim>& list) {
  const Points<Dim>& points = body.points;
  list.add("shear_strain", "-", points.shear_strain);
  list.add("stress", 6, "Pa", [&](Index p, int c) { return tensor_component(points.stress, 0, p, c); });
  list.add("mean_pressure", 1, "Pa",
           [&](Index p, int) { return -(points.stress[0][p] + points.stress[1][p] + points.stress[2][p]) / 3.0; });
  list.add("q", 1, "Pa", [&](Index p, int) { return von_mises(points.stress, p); });
  list.add("work", 1, "J/m3", [&](Index p, int) { return points.work[0][p] / points.initial_volume[0][p]; });
  list.add("rate_norm", "1/s", points.rate_norm);
  if (body.averager) list.add("averaged", averaged_unit(body), points.averaged);
}

template <int Dim>
void add_numbers(const Points<Dim>& points, std::size_t before, std::size_t body, FieldList<Dim>& list) {
  list.add("id", 1, "-",
           [&](Index p, int) {
             return static_cast<double>(before) + static_cast<double>(points.id[static_cast<std::size_t>(p)]);
           })
      .whole = true;
  list.add("body", 1, "-", [&](Index, int) { return static_cast<double>(body); }).whole = true;
}

/// @param start of the body's points, by id; null: unknown
template <int Dim>
void add_motion(const Points<Dim>& points, const std::vector<Vec<Dim>>* start, FieldList<Dim>& list) {
  list.add("velocity", 3, "m/s", [&](Index p, int c) { return c < Dim ? points.velocity[c][p] : 0.0; });
  if (start != nullptr)
    list.add("displacement", 3, "m", [&](Index p, int c) {
      const auto id = static_cast<std::size_t>(points.id[static_cast<std::size_t>(p)]);
      return c < Dim ? points.position[c][p] - (*start)[id][c] : 0.0;
    });
  list.add("volume", Dim == 2 ? "m2" : "m3", points.volume);
}

template <int Dim>
void add_deformation(const Points<Dim>& points, FieldList<Dim>& list) {
  list.add("mass", Dim == 2 ? "kg/m" : "kg", points.mass);
  list.add("volume_ratio", 1, "-", [&](Index p, int) { return points.volume[0][p] / points.initial_volume[0][p]; });
  list.add("polar_rotation", 1, "deg",
           [&](Index p, int) { return polar_rotation<Dim>(points.deformation_gradient_of(p)); });
  list.add("deformation_gradient", 9, "-",
           [&](Index p, int c) { return component_of<Dim>(points.deformation_gradient, p, c); });
}

/// Calls visit(points, name, body) for each body, and for each condition of rigid points, whose body is null.
template <int Dim, class Visit>
void for_each_body(const Simulation<Dim>& simulation, const Visit& visit) {
  for (const Body<Dim>& body : simulation.state().bodies) visit(body.points, body.name, &body);
  for (const Boundary<Dim>& condition : simulation.model().conditions)
    if (const Points<Dim>* points = condition->points())
      visit(*points, condition->name(), static_cast<const Body<Dim>*>(nullptr));
}

template <int Dim>
void add_fields(const Simulation<Dim>& simulation, const StartPlaces<Dim>& start, std::vector<Field>& fields) {
  std::size_t before = 0, number = 0;
  for_each_body(simulation, [&](const Points<Dim>& points, const std::string& name, const Body<Dim>* body) {
    FieldList<Dim> list(points, name, before, fields);
    add_numbers(points, before, number, list);
    if (body != nullptr) {
      add_state(*body, list);
      add_stress_and_rates(*body, list);
    }
    add_motion(points, number < start.size() ? &start[number] : nullptr, list);
    if (body != nullptr) add_deformation(points, list);
    list.fill_gaps();
    before += points.place.size();
    ++number;
  });
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
StartPlaces<Dim> places_of(const Simulation<Dim>& simulation) {
  StartPlaces<Dim> places;
  for_each_body(simulation, [&](const Points<Dim>& points, const std::string&, const Body<Dim>*) {
    places.emplace_back();
    for (const Index p : points.place) places.back().push_back(points.position_of(p));
  });
  return places;
}

template <int Dim>
Frame snapshot(const Simulation<Dim>& simulation, const StartPlaces<Dim>& start,
               std::map<std::string, double> scalars) {
  const State<Dim>& state = simulation.state();
  Frame frame{
      .dimension = Dim, .time = state.time, .scalars = std::move(scalars), .position = {}, .corners = {}, .fields = {}};
  for_each_body(simulation, [&](const Points<Dim>& points, const std::string&, const Body<Dim>*) {
    for (const Index p : points.place) {
      const Vec<Dim> x = points.position_of(p);
      for (int a = 0; a < 3; ++a) frame.position.push_back(a < Dim ? x[a] : 0.0);
      add_corners<Dim>(simulation.model().scheme->corners(state.grid, points, p), frame.corners);
    }
  });
  add_fields(simulation, start, frame.fields);
  return frame;
}

template StartPlaces<2> places_of<2>(const Simulation<2>&);
template StartPlaces<3> places_of<3>(const Simulation<3>&);
template Frame snapshot<2>(const Simulation<2>&, const StartPlaces<2>&, std::map<std::string, double>);
template Frame snapshot<3>(const Simulation<3>&, const StartPlaces<3>&, std::map<std::string, double>);

} // namespace riedel
