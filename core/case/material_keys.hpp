/// The keys of a case's material, and what its void ratios must obey.
#pragma once

#include "core/case/case_file.hpp"
#include "core/interface/catalogue.hpp"

#include <functional>

namespace riedel {

/// Appends `material.model` and the law's parameters as `material.<name>`.
/// @param model for an unknown law, the parameters of all laws are appended, so that the law's name is the only error
/// @param usual the law of a case that names none
void append_material(Keys& keys, const Catalogue& catalogue, std::string_view model, std::string_view usual);
void append(Keys& keys, const Keys& more);

/// Makes the law, so that values that do not fit together, and libraries that cannot be used, are told before anything
/// is written. @throws InputError, PluginError
void try_material(const CaseFile& given, const Values& values, const Catalogue& catalogue);
/// Loads the library of a law in a process of its own first. @throws PluginError where it does not survive that
void try_library(const CaseFile& given, const Values& values, const std::function<void()>& load);

/// Whether a law has parameters of strength: cohesion, friction_angle or phi_c. @param material without the section
bool has_strength(const Values& material);
/// The parameters of the same law with a strength of so many times: cohesions and the cut-off of tension times the
/// factor, angles with the tangent times it. @param material without the section
Values weakened(const Values& material, double factor);

/// Whether a law has parameters that bound its void ratio.
bool has_limits_of_void_ratio(const Values& values);
/// Between which void ratios a law of that kind works at a mean pressure: more than `lower`, `upper` at most.
struct VoidRatioLimits {
  double lower, upper;
  [[nodiscard]] bool admit(double e) const { return e > lower && e <= upper; }
};
/// At a pressure [Pa] and the cohesion pressure added to it.
VoidRatioLimits limits_of_void_ratio(const Values& values, double pressure);

/// e_d0 < e_c0 < e_i0, of laws that have such parameters.
void check_limits_of_void_ratio(const Values& values, std::vector<Finding>& errors);
/// A mean pressure p [Pa], the key that gives it, and what messages call it.
struct StartPressure {
  double p;
  std::string key, name;
};
/// p_t of a law that has such a parameter, otherwise 0 [Pa].
double cohesion_pressure(const Values& values);
/// e_d < e0 ≤ e_i at a pressure and the cohesion pressure added to it, where e_i = e_i0 exp[−(3 p/h_s)^n] and e_d
/// likewise, of laws that have such parameters.
/// @param key the void ratio's
void check_void_ratio(const Values& values, const std::string& key, const StartPressure& start,
                      std::vector<Finding>& errors);

} // namespace riedel
