#include "core/step/grid_to_points.hpp"

#include "core/step/group_walk.hpp"
#include "core/step/kernels/point_motion.hpp"

namespace riedel {

template <int Dim>
void update_kinematics(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for_each_gathered<Use::gradients>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    deform(sum, body.points, p, model, dt);
  });
}

template <int Dim>
void deform_and_move(State<Dim>& state, const Model<Dim>& model, double dt) {
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for_each_gathered<Use::gradients>(state, model, [&](const Gathered<Dim>& sum, Body<Dim>& body, Index p) {
    deform(sum, body.points, p, model, dt);
    std::array<Pack, Dim> displacement_increment;
    for (int a = 0; a < Dim; ++a) displacement_increment[a] = Pack::load(body.displacement_increment[a] + p);
    move(body.points, p, displacement_increment);
  });
}

template <int Dim>
void move_scheme_columns(State<Dim>& state, const Model<Dim>& model, double dt) {
  if (model.scheme->point_data_size() == 0) return;
  const PhaseClock::Lap lap(state.clock, Phase::kinematics);
  for (Body<Dim>& body : state.bodies)
    for_each_block(body.points.size(),
                   [&](Range block) { model.scheme->move(state.grid, state.nodes, dt, body.points, block); });
}

template void move_scheme_columns<2>(State<2>&, const Model<2>&, double);
template void move_scheme_columns<3>(State<3>&, const Model<3>&, double);
template void update_kinematics<2>(State<2>&, const Model<2>&, double);
template void update_kinematics<3>(State<3>&, const Model<3>&, double);
template void deform_and_move<2>(State<2>&, const Model<2>&, double);
template void deform_and_move<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
