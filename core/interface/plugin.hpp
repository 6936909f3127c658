/// Plug-ins: shared libraries that provide user-defined laws, schemes, searches, averagers, boundary conditions or
/// transfers, through the same classes as the built-in ones. A plug-in is one source file that ends with, for example,
///   RIEDEL_PLUGIN(riedel::material<Barodesy>)
/// docs/howto/write_a_material.md leads from an equation to a run.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

/// Incremented when a library compiled against older headers would be misinterpreted.
inline constexpr std::uint32_t plugin_abi = 3;

/// What a plug-in exports under the name `riedel_plugin`. The first two members never move.
struct Plugin {
  std::array<char, 12> magic{'r', 'i', 'e', 'd', 'e', 'l', ' ', 'p', 'l', 'u', 'g', '\0'};
  std::uint32_t abi = plugin_abi;
  const char* version = RIEDEL_VERSION; ///< of the headers it was compiled with
  const char* compiler = __VERSION__;
  std::uint32_t sizes = sizes_of_types(); ///< of types that must have the same layout on both sides
  void (*enlist)(Catalogue&) = nullptr;   ///< adds the entries of the plug-in

  static constexpr std::uint32_t sizes_of_types() {
    std::uint32_t mixed = __GXX_ABI_VERSION;
    for (const std::size_t size :
         {sizeof(Catalogue), sizeof(Description), sizeof(Key), sizeof(Values), sizeof(MaterialBatch), sizeof(Motion),
          sizeof(MaterialReport), sizeof(StateVariable), sizeof(Points<2>), sizeof(Points<3>), sizeof(StencilGroup<2>),
          sizeof(StencilGroup<3>), sizeof(BoundaryStep<3>), sizeof(BoundaryReport<3>), sizeof(NodeBox<3>),
          sizeof(Mat<2>), alignof(Mat<2>), sizeof(NeighbourRows)})
      mixed = mixed * 31 + static_cast<std::uint32_t>(size);
    return mixed;
  }
};

/// A class of a plug-in has `name`, and may have `summary` and `source`, all `static constexpr std::string_view`, and
/// `static Keys parameters()` if a case can set any.
template <class Entry>
Description description_of() {
  Description answer{.name = "", .summary = "from a plug-in", .source = ""};
  if constexpr (requires { Entry::kind; })
    answer.name = Entry::kind; // users name their boundary conditions
  else
    answer.name = Entry::name;
  if constexpr (requires { Entry::summary; }) answer.summary = Entry::summary;
  if constexpr (requires { Entry::source; }) answer.source = Entry::source;
  if constexpr (requires { Entry::parameters(); }) answer.parameters = Entry::parameters();
  return answer;
}

/// Makes an object from the values of its parameters if the class takes them.
template <class Entry>
std::unique_ptr<Entry> made_from(const Values& values) {
  if constexpr (std::is_constructible_v<Entry, const Values&>)
    return std::make_unique<Entry>(values);
  else
    return std::make_unique<Entry>();
}

template <class Law>
void material(Catalogue& catalogue) {
  catalogue.materials.add(description_of<Law>(), made_from<Law>);
}

/// In two and three dimensions.
template <template <int> class Scheme>
void scheme(Catalogue& catalogue) {
  catalogue.in_2d.schemes.add(description_of<Scheme<2>>(), made_from<Scheme<2>>);
  catalogue.in_3d.schemes.add(description_of<Scheme<3>>(), made_from<Scheme<3>>);
}

template <template <int> class Search>
void neighbour_search(Catalogue& catalogue) {
  catalogue.in_2d.searches.add(description_of<Search<2>>(), std::make_unique<Search<2>>);
  catalogue.in_3d.searches.add(description_of<Search<3>>(), std::make_unique<Search<3>>);
}

template <template <int> class Averager, int Dim>
void averager_in(Catalogue& catalogue) {
  catalogue.in<Dim>().averagers.add(description_of<Averager<Dim>>(),
                                    [](double length, std::unique_ptr<NeighbourSearch<Dim>> search) {
                                      return std::make_unique<Averager<Dim>>(length, std::move(search));
                                    });
}

/// For a class that is made from l_c [m] and a search.
template <template <int> class Averager>
void averager(Catalogue& catalogue) {
  averager_in<Averager, 2>(catalogue);
  averager_in<Averager, 3>(catalogue);
}

template <template <int> class Condition, int Dim>
void boundary_condition_in(Catalogue& catalogue) {
  catalogue.in<Dim>().boundaries.add(description_of<Condition<Dim>>(),
                                     [](const std::string& name, const NodeBox<Dim>& place, const Values& values) {
                                       return std::make_unique<Condition<Dim>>(name, place, values);
                                     });
}

/// For a class that is made from a name, a place and the values of its parameters, and is registered under `kind`.
template <template <int> class Condition>
void boundary_condition(Catalogue& catalogue) {
  boundary_condition_in<Condition, 2>(catalogue);
  boundary_condition_in<Condition, 3>(catalogue);
}

template <auto... Add>
void all_of(Catalogue& catalogue) {
  (Add(catalogue), ...);
}

} // namespace riedel

/// Exports a plug-in that provides its arguments: material<Law>, scheme<Scheme>, neighbour_search<Search>,
/// averager<Averager>, boundary_condition<Condition>, transfer<Transfer> of core/step/transfer_plugin.hpp, one or more,
/// all from the namespace riedel.
#define RIEDEL_PLUGIN(...)                                                                                             \
  extern "C" __attribute__((visibility("default")))                                                                    \
  const riedel::Plugin riedel_plugin{.enlist = riedel::all_of<__VA_ARGS__>};
