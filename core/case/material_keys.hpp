/// The keys of a case's material, and the conditions on its void ratios.
#pragma once

#include "core/case/case_file.hpp"
#include "core/interface/catalogue.hpp"

#include <functional>

namespace riedel {

/// Appends `material.model` and the law's parameters as `material.<name>`.
/// @param model if the law is unknown, the parameters of all laws are appended, so that its name is the only error
/// @param usual the law of a case that names none
void append_material(Keys& keys, const Catalogue& catalogue, std::string_view model, std::string_view usual);
void append(Keys& keys, const Keys& more);

/// Makes the law, so that inconsistent values and unusable libraries are reported before anything is written.
/// @throws InputError, PluginError
void try_material(const CaseFile& given, const Values& values, const Catalogue& catalogue);
/// First loads the library of a law in a separate process. @throws PluginError if that process does not survive
void try_library(const CaseFile& given, const Values& values, const std::function<void()>& load);

/// Whether a law has strength parameters: cohesion, friction_angle or phi_c. @param material without the section
bool has_strength(const Values& material);
/// The parameters of the same law with its strength scaled: cohesions and the tension cut-off times the factor, angles
/// such that their tangent is scaled by it. @param material without the section
Values weakened(const Values& material, double factor);

/// Whether a law has parameters that bound its void ratio.
bool has_limits_of_void_ratio(const Values& values);
/// Range of void ratios in which a law of that kind works at a mean pressure: above `lower`, at most `upper`.
struct VoidRatioLimits {
  double lower, upper;
  [[nodiscard]] bool admit(double e) const { return e > lower && e <= upper; }
};
/// At a pressure [Pa] plus the cohesion pressure.
VoidRatioLimits limits_of_void_ratio(const Values& values, double pressure);

/// e_d0 < e_c0 < e_i0, for laws that have these parameters.
void check_limits_of_void_ratio(const Values& values, std::vector<Finding>& errors);
/// A mean pressure p [Pa], the key that gives it, and its name in messages.
struct StartPressure {
  double p;
  std::string key, name;
};
/// p_t of a law that has this parameter, otherwise 0 [Pa].
double cohesion_pressure(const Values& values);
/// e_d < e0 ≤ e_i at a pressure plus the cohesion pressure, where e_i = e_i0 exp[−(3 p/h_s)^n], likewise e_d, for laws
/// that have these parameters.
/// @param key the void ratio's
void check_void_ratio(const Values& values, const std::string& key, const StartPressure& start,
                      std::vector<Finding>& errors);

} // namespace riedel
