#include "apps/velocity_transfers.hpp"

#include <algorithm>

namespace riedel {

const std::vector<std::string>& transfer_names() {
  static const std::vector<std::string> all{"flip", "apic", "tpic", "xpic"};
  return all;
}

VelocityTransfer transfer_named(const std::string& name) {
  constexpr std::array all{VelocityTransfer::flip, VelocityTransfer::apic, VelocityTransfer::tpic,
                           VelocityTransfer::xpic};
  const auto found = std::ranges::find(transfer_names(), name);
  if (found == transfer_names().end())
    throw InputError("unknown transfer '" + name + "'; known: flip, apic, tpic, xpic");
  return all[static_cast<std::size_t>(found - transfer_names().begin())];
}

} // namespace riedel
