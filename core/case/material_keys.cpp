#include "core/case/material_keys.hpp"

#include "core/base/error.hpp"
#include "core/case/checked_case.hpp"
#include "core/case/plugins.hpp"
#include "core/io/attempt.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riedel {

namespace {

void append_parameters(Keys& keys, const Description& law) {
  for (Key key : law.parameters) {
    key.name = "material." + key.name;
    if (std::ranges::find(keys, key.name, &Key::name) == keys.end()) keys.push_back(std::move(key));
  }
}

bool has_parameters(const Values& values, std::initializer_list<const char*> names) {
  return std::ranges::all_of(names, [&](const char* name) { return values.has(std::string("material.") + name); });
}

} // namespace

void append(Keys& keys, const Keys& more) { keys.insert(keys.end(), more.begin(), more.end()); }

void append_material(Keys& keys, const Catalogue& catalogue, std::string_view model, std::string_view usual) {
  keys.push_back({"material.model", std::string(usual), "", {}, "law of the material", catalogue.materials.names()});
  keys.push_back(plugin_key("material", "the law"));
  const bool known = catalogue.materials.known(model);
  for (const auto& law : catalogue.materials.entries())
    if (!known || law.description.name == model) append_parameters(keys, law.description);
}

void try_material(const CaseFile& given, const Values& values, const Catalogue& catalogue) {
  if (values.has("material.library") && values.text("material.library").empty())
    throw InputError(given.place("material.library") +
                     ": names no library; allowed: the path of a library that has the law");
  const auto& make = catalogue.materials.find(values.text("material.model")).make;
  if (values.has("material.library"))
    try_library(given, values, [&] { static_cast<void>(make(values.section("material"))); });
  static_cast<void>(make(values.section("material")));
}

void try_library(const CaseFile& given, const Values& values, const std::function<void()>& load) {
  const std::string crash = early_end_of(load, "while it is loaded");
  if (!crash.empty())
    throw PluginError(given.place("material.library") + ": " + values.text("material.library") + " " + crash);
}

double cohesion_pressure(const Values& v) {
  return has_parameters(v, {"cohesion_pressure"}) ? v.number("material.cohesion_pressure") : 0.0;
}

bool has_strength(const Values& material) {
  return material.has("cohesion") || material.has("friction_angle") || material.has("phi_c");
}

Values weakened(const Values& material, double factor) {
  constexpr double degree = std::numbers::pi / 180.0;
  Values weak = material;
  for (const char* name : {"cohesion", "cohesion_residual", "cohesion_pressure", "tension_cutoff"})
    if (material.has(name) && !material.is_text(name)) weak.set(name, factor * material.number(name));
  for (const char* name :
       {"friction_angle", "friction_angle_residual", "dilatancy_angle", "dilatancy_angle_residual", "phi_c"})
    if (material.has(name) && !material.is_text(name))
      weak.set(name, std::atan(factor * std::tan(degree * material.number(name))) / degree);
  return weak;
}

bool has_limits_of_void_ratio(const Values& values) { return has_parameters(values, {"e_d0", "e_i0", "h_s", "n"}); }

VoidRatioLimits limits_of_void_ratio(const Values& v, double pressure) {
  const double p = pressure + cohesion_pressure(v);
  const double shrink = std::exp(-std::pow(3.0 * p / v.number("material.h_s"), v.number("material.n")));
  return {v.number("material.e_d0") * shrink, v.number("material.e_i0") * shrink};
}

void check_void_ratio(const Values& v, const std::string& key, const StartPressure& start,
                      std::vector<Finding>& errors) {
  if (!has_limits_of_void_ratio(v)) return;
  const VoidRatioLimits limits = limits_of_void_ratio(v, start.p);
  const double e_0 = v.number(key);
  if (limits.admit(e_0)) return;
  errors.push_back({{key, start.key, "material.e_d0", "material.e_i0", "material.h_s", "material.n"},
                    exact_text(e_0) + " is out of range; the law allows (" + rounded(limits.lower) + ", " +
                        rounded(limits.upper) + "] at the " + start.name});
}

void check_limits_of_void_ratio(const Values& v, std::vector<Finding>& errors) {
  if (!has_parameters(v, {"e_d0", "e_c0", "e_i0"})) return;
  const double e_d0 = v.number("material.e_d0"), e_c0 = v.number("material.e_c0"), e_i0 = v.number("material.e_i0");
  if (e_d0 < e_c0 && e_c0 < e_i0) return;
  errors.push_back(
      {{"material.e_c0", "material.e_d0", "material.e_i0"},
       exact_text(e_c0) + " does not lie between e_d0 = " + exact_text(e_d0) + " and e_i0 = " + exact_text(e_i0)});
}

} // namespace riedel
