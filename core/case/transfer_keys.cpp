#include "core/case/transfer_keys.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// A number that the chosen transfer would not look at. Defaults pass: a run leaves them in its case.toml.
void check_settings(const Values& v, std::vector<Finding>& errors) {
  const std::string& transfer = v.text("time.transfer");
  const std::int64_t order = v.integer("time.xpic_order");
  if (transfer != "xpic" && order != Model<2>().xpic_order)
    errors.push_back({{"time.xpic_order", "time.transfer"},
                      std::to_string(order) + " means nothing to \"" + transfer +
                          "\"; leave it out, or take time.transfer = \"xpic\""});
}

/// Affine transfers take the slope of the velocity about a point, which hats do not spread.
void check_spreading(const Values& v, const Catalogue& catalogue, Findings& found) {
  const auto& schemes = catalogue.in_2d.schemes;
  const std::string &scheme = v.text("scheme"), &transfer = v.text("time.transfer");
  const auto spreads = [&](const std::string& name) {
    return schemes.find(name).make(v.section("interpolation"))->spreads_points();
  };
  if (!is_affine(transfer_named(transfer)) || spreads(scheme)) return;
  std::string others;
  for (const std::string& name : schemes.names())
    if (spreads(name)) others += (others.empty() ? "" : ", ") + name;
  if (transfer == "apic")
    found.errors.push_back({{"time.transfer", "scheme"},
                            "\"apic\" is not offered by the scheme \"" + scheme +
                                "\", which gives a point on a line of nodes no weight beside it; take one of " +
                                others + ", or another transfer"});
  else
    found.warnings.push_back(
        {{"time.transfer", "scheme"},
         "\"" + transfer + "\" with the scheme \"" + scheme +
             "\" takes slopes from slivers of mass at free surfaces, and the run may fail; safe with " + others});
}

} // namespace

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

void check_transfer(const Values& values, const Catalogue& catalogue, Findings& found) {
  check_settings(values, found.errors);
  check_spreading(values, catalogue, found);
}

} // namespace riedel
