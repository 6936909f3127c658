/// A wall with Coulomb friction, node by node: Bardenhagen, Brackbill & Sulsky (2000), Comput. Methods Appl. Mech.
/// Engrg. 187, 529–541, section 3, for one body and a rigid wall.
#pragma once

#include "core/step/boundaries/nodewise.hpp"
#include "core/step/boundaries/velocity_course.hpp"

namespace riedel {

template <int Dim>
struct FrictionOnNodes {
  std::string name;
  NodeBox<Dim> place{};                  ///< nodes on the wall and behind it
  double coefficient = 0.0;              ///< μ, static and kinetic [-]
  bool separates = true;                 ///< material may leave the wall
  VelocityCourse velocity{};             ///< of the wall [m/s]; none: it is at rest
  Vec<Dim> direction = Vec<Dim>::Zero(); ///< unit vector along this velocity
};

/// With u the velocity of a node relative to the wall, and n into the material: if u_n ≥ 0, a node that may separate is
/// free. All others get the impulse m Δu_n = −m u_n, and against their slip −m u_t if that does not exceed μ m Δu_n
/// (they stick), otherwise μ m Δu_n. A node is in contact as soon as its support contains material.
template <int Dim>
class FrictionWall final : public Nodewise<FrictionWall<Dim>, Dim> {
public:
  static constexpr std::string_view kind = "friction";
  static Keys parameters();

  explicit FrictionWall(FrictionOnNodes<Dim> given);
  FrictionWall(const std::string& name, const NodeBox<Dim>& place, const Values& values);

  void bind(const Grid<Dim>& grid, const ShapeFunction<Dim>& scheme) override;
  [[nodiscard]] std::array<Walls, Dim> walls(const Grid<Dim>& grid) const override;

  Vec<Dim> velocity(const FreeNode<Dim>& node);
  Vec<Dim> velocity_alone(const FreeNode<Dim>& node) const;
  [[nodiscard]] Vec<Dim> motion(double time) const;

private:
  enum class Contact : char { none, sliding, sticking };

  FrictionOnNodes<Dim> given_;
  std::vector<Contact> contact_; ///< of each node since the last momentum balance
};

} // namespace riedel
