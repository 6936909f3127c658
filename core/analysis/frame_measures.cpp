#include "core/analysis/frame_measures.hpp"

#include "core/io/figure_json.hpp"

#include <numbers>

namespace riedel {

namespace {

/// Positions of a plane frame's points in the specimen's axes.
struct Places {
  std::vector<double> x, y;

  Places(const Frame& frame, const Placement& in_specimen) : x(frame.points()), y(frame.points()) {
    for (std::size_t p = 0; p < x.size(); ++p) {
      const Vec<2> own(frame.position[3 * p], frame.position[3 * p + 1]), place = in_specimen ? in_specimen(own) : own;
      x[p] = place[0];
      y[p] = place[1];
    }
  }
};

std::vector<double> void_ratios(const Frame& frame) {
  return frame.has("void_ratio") ? frame.field("void_ratio").values : std::vector<double>{};
}

} // namespace

ShearBand measure_band(const Frame& all, const BandSettings& settings, const Placement& in_specimen) {
  const Frame frame = deformable_points(all);
  const Places places(frame, in_specimen);
  const std::vector<double> e = void_ratios(frame);
  const auto& J = frame.field("volume_ratio").values;
  std::vector<double> e_0(e.size()), rotation = frame.field("polar_rotation").values;
  for (std::size_t p = 0; p < e.size(); ++p) e_0[p] = (1.0 + e[p]) / J[p] - 1.0; // grains keep their volume
  for (double& angle : rotation) angle *= std::numbers::pi / 180.0;
  return measure_shear_band({.x = places.x,
                             .y = places.y,
                             .volume = frame.field("volume").values,
                             .void_ratio = e,
                             .initial_void_ratio = e_0,
                             .rotation = rotation,
                             .shear = frame.field("shear_strain").values,
                             .rate = frame.field("rate_norm").values},
                            settings);
}

StressQuality measure_quality(const Frame& all, const ShearBand& band, const QualitySettings& settings,
                              const Placement& in_specimen) {
  const Frame frame = deformable_points(all);
  const Places places(frame, in_specimen);
  const std::vector<double> e = void_ratios(frame);
  return measure_stress_quality({.x = places.x,
                                 .y = places.y,
                                 .pressure = frame.field("mean_pressure").values,
                                 .void_ratio = e,
                                 .rate = frame.field("rate_norm").values},
                                band, settings);
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

nlohmann::ordered_json quality_json(const StressQuality& quality) {
  const bool measured = quality.core_points > 0;
  nlohmann::ordered_json json{{"pressure_scatter", figure_json(quality.pressure_scatter)},
                              {"void_ratio_scatter", figure_json(quality.void_ratio_scatter)},
                              {"rate_scatter", figure_json(quality.rate_scatter)},
                              {"core_points", nullptr},
                              {"stressless_in_band", nullptr},
                              {"doubt", nullptr}};
  if (measured) json["core_points"] = quality.core_points, json["stressless_in_band"] = quality.without_stress;
  if (const std::string doubt = quality.doubt(); !doubt.empty()) json["doubt"] = doubt;
  return json;
}

} // namespace riedel
