/// How a summary tells a figure that a run may not have.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace riedel {

/// null for what is not a number: zero would be a figure.
inline nlohmann::ordered_json figure_json(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
}

/// A figure that a reader of a summary finds; not a number where there is none.
inline double figure_in(const nlohmann::ordered_json& json, const char* name) {
  if (!json.is_object() || !json.contains(name) || !json.at(name).is_number()) return std::nan("");
  return json.at(name).get<double>();
}

/// Whether a summary's flag says yes; not where it is null or absent.
inline bool flag_in(const nlohmann::ordered_json& json, const char* name) {
  return json.is_object() && json.contains(name) && json.at(name).is_boolean() && json.at(name).get<bool>();
}

/// A summary's text, or `otherwise` where it is null or absent.
inline std::string text_in(const nlohmann::ordered_json& json, const char* name, const std::string& otherwise) {
  const bool present = json.is_object() && json.contains(name) && json.at(name).is_string();
  return present ? json.at(name).get<std::string>() : otherwise;
}

} // namespace riedel
