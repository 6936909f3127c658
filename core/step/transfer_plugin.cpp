#include "core/step/transfer_plugin.hpp"

#include <stdexcept>

namespace riedel {

void check_sizes_in_a_step(std::uint32_t of_plugin) {
  if (of_plugin != sizes_in_a_step())
    throw std::runtime_error("its transfer has a different layout of a step's state; compile it against the headers of "
                             "this program, with its compiler and options");
}

} // namespace riedel
