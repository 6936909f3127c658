#include "transfers/register.hpp"

#include "transfers/apic.hpp"
#include "transfers/flip.hpp"
#include "transfers/tpic.hpp"
#include "transfers/xpic.hpp"

namespace riedel {

namespace {
template <class Transfer, int Dim>
void add(VelocityTransfers<Dim>& transfers, std::string summary, std::string source) {
  Description description{
      .name = std::string(Transfer::name), .summary = std::move(summary), .source = std::move(source)};
  if constexpr (std::is_constructible_v<Transfer, const Values&>) {
    description.parameters = Transfer::parameters();
    transfers.add(std::move(description), [](const Values& options) { return std::make_unique<Transfer>(options); });
  } else {
    transfers.add(std::move(description), [](const Values&) { return std::make_unique<Transfer>(); });
  }
}
} // namespace

/// The first one is the default.
template <int Dim>
void register_transfers(VelocityTransfers<Dim>& transfers) {
  add<Flip<Dim>>(transfers, "blend of FLIP and PIC: velocity increments, and a share of the grid's velocity",
                 "Brackbill & Ruppel (1986)");
  add<Apic<Dim>>(transfers, "affine: points keep their share of the angular momentum", "Jiang et al. (2015)");
  add<Tpic<Dim>>(transfers, "affine: points keep the gradient of the velocity", "Nakamura et al. (2023)");
  add<Xpic<Dim>>(transfers,
                 "FLIP without the part of the velocities that the grid does not represent, to a given order",
                 "Hammerquist & Nairn (2017)");
}

template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> default_transfer() {
  VelocityTransfers<Dim> transfers{"transfer"};
  register_transfers(transfers);
  const auto& first = transfers.entries().front();
  return first.make(Values(first.description.parameters));
}

template void register_transfers<2>(VelocityTransfers<2>&);
template void register_transfers<3>(VelocityTransfers<3>&);
template std::shared_ptr<const VelocityTransfer<2>> default_transfer<2>();
template std::shared_ptr<const VelocityTransfer<3>> default_transfer<3>();

} // namespace riedel
