/// For plug-ins that bring a transfer of velocities: RIEDEL_PLUGIN(riedel::transfer<MyTransfer>).
#pragma once

#include "core/interface/plugin.hpp"
#include "core/step/model.hpp"

namespace riedel {

/// Mixed from the sizes of what a pass over the points works on, which both sides must lay out alike.
constexpr std::uint32_t sizes_in_a_step() {
  std::uint32_t mixed = 0;
  for (const std::size_t size : {sizeof(State<2>), sizeof(State<3>), sizeof(Model<2>), sizeof(Model<3>),
                                 sizeof(Body<2>), sizeof(Body<3>), sizeof(TransferTraits)})
    mixed = mixed * 31 + static_cast<std::uint32_t>(size);
  return mixed;
}

/// Throws std::runtime_error when the library mixes another number.
void check_sizes_in_a_step(std::uint32_t of_plugin);

/// In two and three dimensions.
template <template <int> class Transfer>
void transfer(Catalogue& catalogue) {
  check_sizes_in_a_step(sizes_in_a_step());
  catalogue.in_2d.transfers.add(description_of<Transfer<2>>(), made_from<Transfer<2>>);
  catalogue.in_3d.transfers.add(description_of<Transfer<3>>(), made_from<Transfer<3>>);
}

} // namespace riedel
