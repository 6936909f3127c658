#include "core/step/boundaries/register.hpp"

#include "core/step/boundaries/friction_wall.hpp"
#include "core/step/boundaries/prescribed_velocity.hpp"
#include "core/step/boundaries/rigid_body.hpp"

namespace riedel {

namespace {
template <class Condition, int Dim>
void add(BoundaryConditions<Dim>& boundaries, std::string summary, std::string source) {
  boundaries.add({.name = std::string(Condition::kind),
                  .summary = std::move(summary),
                  .source = std::move(source),
                  .parameters = Condition::parameters()},
                 [](const std::string& name, const NodeBox<Dim>& place, const Values& values) {
                   return std::make_unique<Condition>(name, place, values);
                 });
}
} // namespace

template <int Dim>
void register_boundaries(BoundaryConditions<Dim>& boundaries) {
  add<PrescribedVelocity<Dim>>(boundaries, "one velocity component, given or free, common to a box of nodes", "");
  add<RigidBody<Dim>>(boundaries, "a block of rigid points that moves through the grid and drives the nodes it touches",
                      "");
  add<FrictionWall<Dim>>(boundaries, "a wall with Coulomb friction, node by node",
                         "Bardenhagen, Brackbill & Sulsky (2000)");
}

template void register_boundaries<2>(BoundaryConditions<2>&);
template void register_boundaries<3>(BoundaryConditions<3>&);

} // namespace riedel
