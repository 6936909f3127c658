/// The one header for user-defined programs: `#include <riedel/riedel.hpp>`, with `riedel::core` and `riedel::io` of
/// `find_package(riedel COMPONENTS io)`. docs/howto/write_a_program.md walks through an example.
#pragma once

#include "core/io/history.hpp"
#include "core/io/snapshot.hpp"
#include "core/io/vtk_writer.hpp"
#include "core/run/run.hpp"
#include "core/setup/fill.hpp"
#include "core/setup/walls.hpp"
#include "core/step/boundaries/friction_wall.hpp"
#include "core/step/boundaries/prescribed_velocity.hpp"
#include "core/step/boundaries/register.hpp"
#include "core/step/boundaries/rigid_body.hpp"
#include "core/step/musl.hpp"
#include "core/step/simulation.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"
#include "materials/kit/elastic_solid.hpp"
#include "materials/kit/rate_law.hpp"
#include "materials/register.hpp"
#include "nonlocal/register.hpp"
#include "shapefunctions/register.hpp"
#include "transfers/register.hpp"

namespace riedel {

/// The schemes, laws, searches, averagers, boundary conditions and transfers that come with the library.
inline Catalogue built_in() {
  Catalogue all;
  register_shape_functions(all.in_2d.schemes);
  register_shape_functions(all.in_3d.schemes);
  register_nonlocal(all.in_2d);
  register_nonlocal(all.in_3d);
  register_boundaries(all.in_2d.boundaries);
  register_boundaries(all.in_3d.boundaries);
  register_materials(all.materials);
  register_transfers(all.in_2d.transfers);
  register_transfers(all.in_3d.transfers);
  return all;
}

/// Makes an entry of a catalogue by name, with its defaults except for the values in `with`.
/// @param args what its factory takes before the values: a boundary condition's name and place
/// @throws InputError for an unknown name or key, or a value that is not allowed
template <class Make, class... Args>
auto make(const Registry<Make>& registry, const std::string& name, const std::map<std::string, Value>& with = {},
          const Args&... args) {
  const auto& entry = registry.find(name);
  Values values(entry.description.parameters);
  for (const auto& [key, value] : with) {
    if (!values.has(key)) throw InputError(registry.kind() + " '" + name + "' has no parameter '" + key + "'");
    values.set(key, value);
  }
  return entry.make(args..., values);
}

} // namespace riedel
