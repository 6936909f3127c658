#include "core/case/transfer_keys.hpp"

#include "core/case/case_text.hpp"
#include "core/step/orders.hpp"

#include <algorithm>

namespace riedel {

namespace {

using Transfers = VelocityTransfers<2>;

bool takes(const Transfers::Entry& transfer, const std::string& parameter) {
  const Keys& all = transfer.description.parameters;
  return std::ranges::find(all, parameter, &Key::name) != all.end();
}

/// Names of the transfers for which a condition holds, such as taking a parameter.
template <class Holds>
std::string names_of(const Transfers& transfers, const std::string& between, const Holds& holds) {
  std::string all;
  for (const Transfers::Entry& transfer : transfers.entries())
    if (holds(transfer)) all += (all.empty() ? "" : between) + transfer.description.name;
  return all;
}

/// A damping rate, for which a case may give "auto".
bool is_rate(const Key& key) {
  return key.unit == "1/s" && std::ranges::find(key.choices, "auto") != key.choices.end();
}

/// Refuses a number that the chosen transfer ignores. Defaults pass, since a run writes them to its case.toml.
void check_settings(const Values& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const Transfers& transfers = catalogue.in_2d.transfers;
  const auto& chosen = transfers.find(v.text("time.transfer"));
  for (const Key& key : transfer_keys(catalogue, "")) {
    const std::string parameter = key.name.substr(key.name.find('.') + 1);
    if (takes(chosen, parameter) || v.at(key.name) == key.default_value) continue;
    errors.push_back({{key.name, "time.transfer"},
                      toml_text(v.at(key.name)) + " means nothing to \"" + chosen.description.name +
                          "\"; leave it out, or take time.transfer = \"" +
                          names_of(transfers, "\" or \"", [&](const auto& one) { return takes(one, parameter); }) +
                          "\""});
  }
}

/// Transfers that use the velocity gradient about a point need a scheme that spreads its weights, which hats do not.
void check_spreading(const Values& v, const Catalogue& catalogue, TransferTraits::Spread spread, Diagnostics& found) {
  using Spread = TransferTraits::Spread;
  const auto& schemes = catalogue.in_2d.schemes;
  const std::string &scheme = v.text("scheme"), &transfer = v.text("time.transfer");
  const auto spreads = [&](const std::string& name) {
    return schemes.find(name).make(v.section("interpolation"))->supports_affine();
  };
  if (spread == Spread::any || spreads(scheme)) return;
  std::string others;
  for (const std::string& name : schemes.names())
    if (spreads(name)) others += (others.empty() ? "" : ", ") + name;
  if (spread == Spread::needed)
    found.errors.push_back({{"time.transfer", "scheme"},
                            "\"" + transfer + "\" is not offered by the scheme \"" + scheme +
                                "\", which gives a point on a line of nodes no weight beside that line; take one of " +
                                others + ", or another transfer"});
  else
    found.warnings.push_back(
        {{"time.transfer", "scheme"},
         "\"" + transfer + "\" with the scheme \"" + scheme +
             "\" takes gradients from nodes with tiny masses at free surfaces, and the run may fail; safe with " +
             others});
}

void check_order(const Values& v, const TransferTraits& traits, std::vector<Finding>& errors) {
  const std::string& order = v.text("time.order");
  if (traits.goes_with(order)) return;
  std::string others;
  for (const StepOrder<2>& other : orders_of_step<2>)
    if (traits.goes_with(other.name)) others += (others.empty() ? "\"" : " or \"") + std::string(other.name) + "\"";
  errors.push_back({{"time.transfer", "time.order"},
                    "\"" + v.text("time.transfer") + "\" does not go with \"" + order +
                        "\"; take time.order = " + others + ", or another transfer"});
}

} // namespace

Keys transfer_keys(const Catalogue& catalogue, const std::string& of_auto) {
  const Transfers& transfers = catalogue.in_2d.transfers;
  Keys keys;
  for (const Transfers::Entry& transfer : transfers.entries())
    for (Key key : transfer.description.parameters) {
      const std::string parameter = key.name;
      key.name = "time." + parameter;
      if (std::ranges::find(keys, key.name, &Key::name) != keys.end()) continue;
      if (is_rate(key)) key.doc += "; auto: " + of_auto;
      key.doc += "; for " + names_of(transfers, ", ", [&](const auto& one) { return takes(one, parameter); }) + " only";
      keys.push_back(std::move(key));
    }
  return keys;
}

template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> make_transfer(const Values& values, const Catalogue& catalogue,
                                                           double damping) {
  const auto& transfer = catalogue.in<Dim>().transfers.find(values.text("time.transfer"));
  Values options;
  for (const Key& key : transfer.description.parameters) {
    const Value& given = values.at("time." + key.name);
    options.set(key.name, is_rate(key) && std::holds_alternative<std::string>(given) ? Value(damping) : given);
  }
  return transfer.make(options);
}

void check_transfer(const Values& values, const Catalogue& catalogue, Diagnostics& found) {
  check_settings(values, catalogue, found.errors);
  const TransferTraits traits = make_transfer<2>(values, catalogue, 0.0)->traits();
  check_order(values, traits, found.errors);
  check_spreading(values, catalogue, traits.spread, found);
}

template std::shared_ptr<const VelocityTransfer<2>> make_transfer<2>(const Values&, const Catalogue&, double);
template std::shared_ptr<const VelocityTransfer<3>> make_transfer<3>(const Values&, const Catalogue&, double);

} // namespace riedel
