#include "core/step/boundaries/prescribed_velocity.hpp"

#include "core/step/boundaries/node_box.hpp"

namespace riedel {

namespace {

template <int Dim>
VelocityOnNodes<Dim> from_values(const std::string& name, const NodeBox<Dim>& place, const Values& values) {
  VelocityOnNodes<Dim> given{.name = name, .first = place.first, .last = place.last, .axis = place.axis};
  if (!values.flag("free")) given.velocity = velocity_course(values);
  return given;
}

} // namespace

template <int Dim>
Keys PrescribedVelocity<Dim>::parameters() {
  Keys keys = velocity_keys();
  keys.push_back({"free", false, "", {}, "the nodes move together, by their momentum; the velocity is ignored"});
  return keys;
}

template <int Dim>
PrescribedVelocity<Dim>::PrescribedVelocity(VelocityOnNodes<Dim> given)
    : CommonMotion<Dim>(given.name, {.axis = given.axis}, given.velocity), given_(std::move(given)) {}

template <int Dim>
PrescribedVelocity<Dim>::PrescribedVelocity(const std::string& name, const NodeBox<Dim>& place, const Values& values)
    : PrescribedVelocity(from_values(name, place, values)) {}

template <int Dim>
void PrescribedVelocity<Dim>::bind(const Grid<Dim>& grid, const ShapeFunction<Dim>&) {
  this->nodes_.clear();
  this->factors_.clear();
  for (Index i = 0; i < grid.node_count(); ++i) {
    const Counts<Dim> index = grid.index(i);
    if (!within_box<Dim>(index, given_.first, given_.last)) continue;
    if (given_.but_for && within_box<Dim>(index, given_.but_for->front(), given_.but_for->back())) continue;
    this->nodes_.push_back(i);
    if (const auto& linear = given_.linear)
      this->factors_.push_back(static_cast<double>(index[linear->axis] - linear->fixed_row) /
                               static_cast<double>(linear->moving_row - linear->fixed_row));
  }
}

template <int Dim>
std::array<Walls, Dim> PrescribedVelocity<Dim>::walls(const Grid<Dim>& grid) const {
  NodeBox<Dim> box{.first = given_.first, .last = given_.last, .axis = given_.axis};
  const auto& linear = given_.linear;
  if (!linear || linear->axis != box.axis) return walls_of(grid, box);
  // A motion that grows across the rows: the fixed row and the moving row are walls, each with everything beyond it.
  box.first[box.axis] = 0;
  box.last[box.axis] = linear->fixed_row;
  std::array<Walls, Dim> walls = walls_of(grid, box);
  if (walls[box.axis].first == linear->fixed_row) walls[box.axis].last = linear->moving_row;
  return walls;
}

template class PrescribedVelocity<2>;
template class PrescribedVelocity<3>;

} // namespace riedel
