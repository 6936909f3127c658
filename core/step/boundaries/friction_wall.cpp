#include "core/step/boundaries/friction_wall.hpp"

namespace riedel {

namespace {

template <int Dim>
Vec<Dim> unit_vector(const std::vector<double>& components, int axis, const std::string& name) {
  if (components.empty()) return Vec<Dim>::Unit(axis);
  Vec<Dim> direction = Vec<Dim>::Zero();
  for (std::size_t a = 0; a < Dim && a < components.size(); ++a) direction[a] = components[a];
  if (components.size() != Dim || !(direction.norm() > 0.0))
    throw InputError("wall '" + name + "': direction has " + std::to_string(components.size()) +
                     " entries; allowed: " + std::to_string(Dim) + ", not all zero, or none");
  return direction.normalized();
}

template <int Dim>
FrictionOnNodes<Dim> from_values(const std::string& name, const NodeBox<Dim>& place, const Values& values) {
  return {.name = name,
          .place = place,
          .coefficient = values.number("friction"),
          .separates = values.flag("separates"),
          .velocity = velocity_course(values),
          .direction = unit_vector<Dim>(values.numbers("direction"), place.axis, name)};
}

} // namespace

template <int Dim>
Keys FrictionWall<Dim>::parameters() {
  Keys keys{{"friction", 0.3, "-", at_least(0.0), "coefficient of friction"},
            {"separates", true, "", {}, "material may leave the wall"}};
  for (Key& key : velocity_keys()) keys.push_back(std::move(key));
  keys.push_back(
      {"direction", std::vector<double>{}, "-", {}, "of the wall's velocity; empty: along the axis", {}, true});
  return keys;
}

template <int Dim>
FrictionWall<Dim>::FrictionWall(FrictionOnNodes<Dim> given)
    : Nodewise<FrictionWall, Dim>(given.name, given.place), given_(std::move(given)) {
  if (!(given_.coefficient >= 0.0) || !std::isfinite(given_.coefficient))
    throw InputError("wall '" + given_.name + "': its coefficient of friction is " + exact_text(given_.coefficient) +
                     "; allowed: ≥ 0");
}

template <int Dim>
FrictionWall<Dim>::FrictionWall(const std::string& name, const NodeBox<Dim>& place, const Values& values)
    : FrictionWall(from_values(name, place, values)) {}

template <int Dim>
void FrictionWall<Dim>::bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) {
  Nodewise<FrictionWall, Dim>::bind(grid, scheme);
  contact_.assign(this->nodes().size(), Contact::none);
}

template <int Dim>
std::array<Walls, Dim> FrictionWall<Dim>::walls(const Grid<Dim>& grid) const {
  return walls_of(grid, given_.place);
}

template <int Dim>
Vec<Dim> FrictionWall<Dim>::motion(double time) const {
  return given_.velocity ? Vec<Dim>(given_.velocity(time) * given_.direction) : Vec<Dim>(Vec<Dim>::Zero());
}

template <int Dim>
Vec<Dim> FrictionWall<Dim>::velocity(const FreeNode<Dim>& node) {
  const Vec<Dim> wall = motion(node.time);
  const int axis = given_.place.axis;
  Vec<Dim> u = node.velocity - wall;
  const double u_n = given_.place.behind == Behind::lower ? u[axis] : -u[axis];
  Contact& contact = contact_[node.k];
  contact = Contact::none;
  if (given_.separates && u_n >= 0.0) return node.velocity;
  u[axis] = 0.0; // the remainder is the slip u_t
  const double slip = u.norm(), allowed = given_.coefficient * std::max(-u_n, 0.0);
  contact = slip > allowed ? Contact::sliding : Contact::sticking;
  if (contact == Contact::sticking) return wall;
  return wall + (1.0 - allowed / slip) * u;
}

/// Nodes in contact stay in contact, sticking nodes keep sticking, and no node moves into the wall.
template <int Dim>
Vec<Dim> FrictionWall<Dim>::velocity_alone(const FreeNode<Dim>& node) const {
  const Vec<Dim> wall = motion(node.time);
  const int axis = given_.place.axis;
  const double apart = node.velocity[axis] - wall[axis], u_n = given_.place.behind == Behind::lower ? apart : -apart;
  const Contact contact = contact_[node.k];
  if (contact == Contact::sticking) return wall;
  Vec<Dim> v = node.velocity;
  if (contact == Contact::sliding || !given_.separates || u_n < 0.0) v[axis] = wall[axis];
  return v;
}

template class FrictionWall<2>;
template class FrictionWall<3>;

} // namespace riedel
