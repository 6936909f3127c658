/// Entries of the catalogue, by name.
#pragma once

#include "apps/built_in.hpp"

#include <algorithm>

namespace riedel::test {

inline const Catalogue& catalogue() {
  static const Catalogue all = full_catalogue();
  return all;
}

/// Whether a case can set `parameter` for a law.
inline bool law_has(const std::string& law, std::string_view parameter) {
  const Keys& keys = catalogue().materials.find(law).description.parameters;
  return std::ranges::any_of(keys, [&](const Key& key) { return key.name == parameter; });
}

/// The laws that run with their defaults: a foreign one needs a library; those in tests/plugin have one.
inline std::vector<std::string> law_names() {
  std::vector<std::string> names = catalogue().materials.names();
  std::erase_if(names, [](const std::string& name) { return law_has(name, "library"); });
  return names;
}

inline std::vector<std::string> laws_with(std::string_view parameter) {
  std::vector<std::string> names = law_names();
  std::erase_if(names, [&](const std::string& name) { return !law_has(name, parameter); });
  return names;
}

/// The defaults except for the values in `with`.
template <class Entry>
Values values_of(const Entry& entry, const std::map<std::string, Value>& with) {
  Values values(entry.description.parameters);
  for (const auto& [key, value] : with) values.set(key, value);
  return values;
}

inline std::shared_ptr<const Material> material(const std::string& name, std::map<std::string, Value> with = {}) {
  const auto& entry = catalogue().materials.find(name);
  return entry.make(values_of(entry, with));
}

template <int Dim>
std::shared_ptr<const ShapeFunction<Dim>> scheme(const std::string& name,
                                                 const std::map<std::string, Value>& with = {}) {
  const auto& entry = catalogue().in<Dim>().schemes.find(name);
  return entry.make(values_of(entry, with));
}

template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> transfer(const std::string& name,
                                                      const std::map<std::string, Value>& with = {}) {
  const auto& entry = catalogue().in<Dim>().transfers.find(name);
  return entry.make(values_of(entry, with));
}

/// Names of all registered schemes, for parameterised suites.
inline std::vector<std::string> scheme_names() { return catalogue().in_2d.schemes.names(); }

inline std::vector<std::string> transfer_names() { return catalogue().in_2d.transfers.names(); }

/// Whether a transfer can be used with a scheme.
inline bool goes_with(const std::string& transfer_name, const std::string& scheme_name) {
  return transfer<2>(transfer_name)->traits().spread != TransferTraits::Spread::needed ||
         scheme<2>(scheme_name)->supports_affine();
}

} // namespace riedel::test
