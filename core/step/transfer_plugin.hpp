/// For plug-ins that provide a velocity transfer: RIEDEL_PLUGIN(riedel::transfer<MyTransfer>).
#pragma once

#include "core/interface/plugin.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// A hash of the sizes of the types used in a pass over the points, which must have the same layout on both sides.
constexpr std::uint32_t sizes_in_a_step() {
  std::uint32_t mixed = 0;
  for (const std::size_t size : {sizeof(State<2>), sizeof(State<3>), sizeof(Model<2>), sizeof(Model<3>),
                                 sizeof(Body<2>), sizeof(Body<3>), sizeof(TransferTraits)})
    mixed = mixed * 31 + static_cast<std::uint32_t>(size);
  return mixed;
}

/// Throws std::runtime_error if the library's hash differs.
void check_sizes_in_a_step(std::uint32_t of_plugin);

/// In two and three dimensions.
template <template <int> class Transfer>
void transfer(Catalogue& catalogue) {
  check_sizes_in_a_step(sizes_in_a_step());
  catalogue.in_2d.transfers.add(description_of<Transfer<2>>(), made_from<Transfer<2>>);
  catalogue.in_3d.transfers.add(description_of<Transfer<3>>(), made_from<Transfer<3>>);
}

} // namespace riedel
