/// Representation in a summary of a value that a run may not have.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace riedel {

/// null for NaN, since zero would be a value.
inline nlohmann::ordered_json figure_json(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
}

/// A value read from a summary; NaN if there is none.
inline double figure_in(const nlohmann::ordered_json& json, const char* name) {
  if (!json.is_object() || !json.contains(name) || !json.at(name).is_number()) return std::nan("");
  return json.at(name).get<double>();
}

/// A flag of a summary; false if it is null or absent.
inline bool flag_in(const nlohmann::ordered_json& json, const char* name) {
  return json.is_object() && json.contains(name) && json.at(name).is_boolean() && json.at(name).get<bool>();
}

/// A text of a summary, or `otherwise` if it is null or absent.
inline std::string text_in(const nlohmann::ordered_json& json, const char* name, const std::string& otherwise) {
  const bool present = json.is_object() && json.contains(name) && json.at(name).is_string();
  return present ? json.at(name).get<std::string>() : otherwise;
}

} // namespace riedel
