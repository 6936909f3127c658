/// Maps names to factories for everything that a case can name: schemes, laws, searches, averagers, boundary
/// conditions.
#pragma once

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

namespace riedel {

/// What `riedel list` prints for one entry.
struct Description {
  std::string name;
  std::string summary;  ///< one line
  std::string source;   ///< the paper it comes from
  Keys parameters = {}; ///< what the case may set for it
};

/// A list of named factories, in the order they were added.
/// @tparam Make the factory's signature, such as `std::unique_ptr<Material>(const Values&)`
template <class Make>
class Registry {
public:
  struct Entry {
    Description description;
    std::function<Make> make;
  };

  explicit Registry(std::string kind) : kind_(std::move(kind)) {}

  /// Throws PluginError if the name is taken.
  void add(Description description, std::function<Make> make) {
    if (known(description.name)) throw PluginError("two " + kind_ + "s are named '" + description.name + "'");
    entries_.push_back({std::move(description), std::move(make)});
  }
  /// Names an entry that this build lacks. @param how to get it, as the end of a sentence
  void leave_out(std::string name, std::string how) { left_out_.insert_or_assign(std::move(name), std::move(how)); }
  [[nodiscard]] const std::map<std::string, std::string>& left_out() const { return left_out_; }
  [[nodiscard]] bool known(std::string_view name) const {
    return std::ranges::any_of(entries_, [&](const Entry& e) { return e.description.name == name; });
  }
  /// Throws InputError that lists the known names, or says how to get an entry that was left out.
  [[nodiscard]] const Entry& find(std::string_view name) const {
    for (const Entry& entry : entries_)
      if (entry.description.name == name) return entry;
    if (const auto missing = left_out_.find(std::string(name)); missing != left_out_.end())
      throw InputError(kind_ + " '" + missing->first + "' " + missing->second + "; known: " + names_text());
    throw InputError("unknown " + kind_ + " '" + std::string(name) + "'; known: " + names_text());
  }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Entry& entry : entries_) all.push_back(entry.description.name);
    return all;
  }
  [[nodiscard]] const std::string& kind() const { return kind_; }

private:
  [[nodiscard]] std::string names_text() const {
    std::string text;
    for (const Entry& entry : entries_) text += (text.empty() ? "" : ", ") + entry.description.name;
    return text;
  }
  std::string kind_;
  std::vector<Entry> entries_;
  std::map<std::string, std::string> left_out_;
};

} // namespace riedel
