#include "apps/band_report.hpp"

#include "apps/figure_json.hpp"
#include "apps/specimen_geometry.hpp"

#include <numbers>

namespace riedel {

ShearBand measure_band(const Frame& frame, const Values& values) {
  const bool has_void_ratio = frame.has("void_ratio");
  const std::size_t count = frame.points();
  const Turn turn(values);
  const std::vector<double> e = has_void_ratio ? frame.field("void_ratio").values : std::vector<double>{};
  const auto& J = frame.field("volume_ratio").values;
  std::vector<double> x(count), y(count), e_0(e.size()), rotation = frame.field("polar_rotation").values;
  for (std::size_t p = 0; p < count; ++p) {
    const Vec<2> place = turn.to_specimen({frame.position[3 * p], frame.position[3 * p + 1]});
    x[p] = place[0];
    y[p] = place[1];
    if (has_void_ratio) e_0[p] = (1.0 + e[p]) / J[p] - 1.0; // grains keep their volume
    rotation[p] *= std::numbers::pi / 180.0;
  }
  const BandSettings settings{.length = values.number("nonlocal.length"),
                              .threshold = values.number("output.band_void_ratio")};
  return measure_shear_band({.x = x,
                             .y = y,
                             .volume = frame.field("volume").values,
                             .void_ratio = e,
                             .initial_void_ratio = e_0,
                             .rotation = rotation,
                             .shear = frame.field("shear_strain").values,
                             .rate = frame.field("rate_norm").values},
                            settings);
}

nlohmann::ordered_json band_json(const ShearBand& band) {
  nlohmann::ordered_json json{{"found", band.found},
                              {"kind", name_of(band.kind)},
                              {"doubt", nullptr},
                              {"measured_by", band.by_shear ? "shear_strain" : "void_ratio"}};
  if (const std::string doubt = band.doubt(); !doubt.empty()) json["doubt"] = doubt;
  const std::pair<const char*, double> figures[] = {
      {"inclination_deg", band.inclination_deg},       {"thickness_m", band.thickness_m},
      {"thickness_fwhm_m", band.thickness_fwhm_m},     {"thickness_rate_m", band.thickness_rate_m},
      {"thickness_over_lc", band.thickness_over_lc},   {"void_ratio_inside", band.void_ratio_inside},
      {"localisation_ratio", band.localisation_ratio}, {"conjugate_ratio", band.conjugate_ratio},
      {"straight_length_m", band.straight_length_m}};
  for (const auto& [name, figure] : figures) json[name] = figure_json(figure);
  return json;
}

} // namespace riedel
