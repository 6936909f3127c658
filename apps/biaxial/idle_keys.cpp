#include "apps/biaxial/idle_keys.hpp"

#include "core/case/case_text.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// Keys without effect, and why.
struct Idle {
  bool holds;
  std::vector<std::string> keys;
  std::string why;
};

bool is_off(const Values& v, const std::string& key) { return v.has(key) && !v.flag(key); }

/// Does a law with residual values not soften, because they are those of the peak?
bool keeps_its_strength(const Values& v) {
  if (!v.has("material.softening_strain")) return false;
  return std::ranges::all_of(std::array{"material.cohesion", "material.friction_angle", "material.dilatancy_angle"},
                             [&](const char* name) {
                               const std::string residual = std::string(name) + "_residual";
                               return v.is_text(residual) || v.number(residual) == v.number(name);
                             });
}

std::vector<Idle> idle_keys(const Values& v) {
  const auto& size = v.numbers("imperfection.size");
  const bool local = v.number("nonlocal.length") == 0.0;
  return {
      {local,
       {"nonlocal.variable", "nonlocal.search", "nonlocal.averager", "nonlocal.plugin"},
       "the run is local, nonlocal.length = 0"},
      {size[0] * size[1] == 0.0,
       {"imperfection.void_ratio", "imperfection.centre", "imperfection.factor"},
       "there is no patch, imperfection.size = " + toml_text(v.at("imperfection.size"))},
      {v.number("imperfection.deviation") == 0.0,
       {"imperfection.correlation_length", "imperfection.seed"},
       "there is no random field, imperfection.deviation = 0"},
      {!v.flag("output.vtk"), {"output.frames_every_strain"}, "no frames are written, output.vtk = false"},
      {!v.is_text("time.step"), {"time.cfl"}, "time.step is given"},
      {is_off(v, "material.intergranular_strain"),
       {"material.m_R", "material.m_T", "material.R", "material.beta_R", "material.chi"},
       "material.intergranular_strain = false"},
      {keeps_its_strength(v),
       {"material.softening_strain", "material.nonlocal_factor"},
       "the law does not soften: its residual values are those of the peak"},
      {local && !keeps_its_strength(v), {"material.nonlocal_factor"}, "the run is local, nonlocal.length = 0"},
  };
}

} // namespace

bool is_set(const CaseFile& given, const Keys& keys, const Values& values, const std::string& key) {
  const auto found = std::ranges::find(keys, key, &Key::name);
  const std::vector<std::string> names = given.names_in(key.substr(0, key.find('.')));
  return found != keys.end() && std::ranges::find(names, key) != names.end() && values.at(key) != found->default_value;
}

void check_idle_keys(const CaseFile& given, const Keys& keys, const Values& values, std::vector<Finding>& warnings) {
  for (const Idle& idle : idle_keys(values))
    for (const std::string& key : idle.keys)
      if (idle.holds && is_set(given, keys, values, key))
        warnings.push_back({{key}, toml_text(values.at(key)) + " has no effect: " + idle.why});
}

} // namespace riedel
