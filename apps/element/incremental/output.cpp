#include "apps/element/incremental/output.hpp"

#include "core/io/units.hpp"

#include <cstdio>

namespace riedel {

namespace {

constexpr double root = std::numbers::sqrt2;
constexpr int none = -1, of_water = -2;

} // namespace

IncrementalOutput::IncrementalOutput(const std::filesystem::path& path, const Material& law, const PoreWater& water,
                                     const Values& material)
    : file_(path), water_(water) {
  if (material.has("stress_unit")) stress_unit_ = read_quantity("1 " + material.text("stress_unit"), "Pa");
  if (material.has("state_names"))
    list_of_umat(law, material);
  else
    list_of_sand(law);
  std::string header = " time(1) time(2)";
  for (const auto& [name, count] :
       {std::pair{" stran(", std::size_t{6}}, {" stress(", 6}, {" statev(", columns_.size()}})
    for (std::size_t i = 1; i <= count; ++i) header += name + std::to_string(i) + ")";
  file_.write(header + "\n");
}

/// The UMAT's own state, without the strain that rotates with the material; tensors according to their names.
void IncrementalOutput::list_of_umat(const Material& law, const Values& material) {
  int column = 0;
  for (const StateVariable& variable : law.states()) {
    const bool stress = material.text("state_names").find(variable.name + ":stress") != std::string::npos;
    if (variable.name != "umat_strain")
      for (int c = 0; c < variable.components; ++c)
        columns_.push_back({column + c, (c < 3 ? 1.0 : stress ? 1.0 / root : root) / (stress ? stress_unit_ : 1.0)});
    column += variable.components;
  }
}

void IncrementalOutput::list_of_sand(const Material& law) {
  const int h = state_column(law.states(), "intergranular_strain"), e = state_column(law.states(), "void_ratio");
  for (int c = 0; c < 6; ++c) columns_.push_back({h < 0 ? none : h + c, c < 3 ? 1.0 : root});
  columns_.push_back({e});
  if (water_.present()) columns_.push_back({of_water});
  for (int c = 0; c < state_components(law.states()); ++c)
    if (c != e && (h < 0 || c < h || c >= h + 6)) columns_.push_back({c});
}

void IncrementalOutput::add(const MaterialPoint& point) {
  std::string text;
  const auto print = [&](double x) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), " %15.8E", x + 0.0);
    text += buffer.data();
  };
  const double u = water_.present() ? water_.pressure(point) : 0.0;
  print(point.time);
  print(point.time);
  for (std::size_t c = 0; c < 6; ++c) print(c < 3 ? point.strain.m[c] : root * point.strain.m[c]);
  for (std::size_t c = 0; c < 6; ++c) print((c < 3 ? point.stress.m[c] - u : point.stress.m[c] / root) / stress_unit_);
  for (const auto& [state, factor] : columns_)
    print(state == none       ? 0.0
          : state == of_water ? -u / stress_unit_
                              : factor * point.state[static_cast<std::size_t>(state)]);
  file_.write(text + "\n");
}

} // namespace riedel
