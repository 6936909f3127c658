#include "apps/element/pictures.hpp"

#include "core/base/error.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// A column of element.csv as an axis shows it.
struct Axis {
  std::string column, label;
  double unit = 1.0; ///< what the column is multiplied by
};

struct PictureOf {
  std::string file;
  Axis x, y;
  bool log_x = false;
};

const Axis eps_1{"eps_1", "vertical strain ε₁ [%]", 100.0}, gamma_u{"gamma", "shear strain γ = u/h₀ [%]", 100.0};
const Axis sigma_1{"sigma_1_Pa", "vertical stress σ₁ [kPa]", 1e-3}, tau{"tau_Pa", "shear stress τ [kPa]", 1e-3};
const Axis p_eff{"p_Pa", "effective mean pressure p [kPa]", 1e-3}, q{"q_Pa", "q = σ₁ − (σ₂ + σ₃)/2 [kPa]", 1e-3};
const Axis phi{"phi_mob_deg", "mobilised friction angle φ [°]"}, e{"void_ratio", "void ratio e [-]"};

std::vector<PictureOf> pictures_of(const std::string& test) {
  const PictureOf stress_strain{"stress_strain.png", eps_1, sigma_1};
  const PictureOf compression{"compression.png", sigma_1, e, true};
  const PictureOf path{"p_q.png", p_eff, q};
  if (test == "oedometer") return {stress_strain, compression, path};
  if (test == "shear")
    return {{"friction.png", gamma_u, phi},
            {"void_ratio.png", gamma_u, e},
            {"stress_strain.png", gamma_u, tau},
            {"p_q.png", p_eff, tau}};
  std::vector<PictureOf> all{
      stress_strain, {"friction.png", eps_1, phi}, {"void_ratio.png", eps_1, e}, compression, path};
  if (test == "path") all.push_back({"shear.png", gamma_u, tau});
  return all;
}

std::string title_of(const std::string& test) {
  if (test == "oedometer") return "Oedometric compression";
  if (test == "triaxial") return "Triaxial compression";
  if (test == "shear") return "Simple shear with free dilatancy";
  return test == "biaxial" ? "Plane strain compression" : "Path";
}

/// A measured column; the pressure of pore water is no part of an effective one.
std::vector<double> column_of(const Table& table, const Axis& axis) {
  std::vector<double> values = table[axis.column];
  if (axis.column == p_eff.column && table.has("pore_pressure_Pa"))
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= table["pore_pressure_Pa"][i];
  for (double& value : values) value *= axis.unit;
  return values;
}

std::vector<double> column_of(const ElementCurve& curve, const Axis& axis) {
  const std::vector<std::string> names = element_columns(curve.test, curve.water);
  const auto index = static_cast<std::size_t>(std::ranges::find(names, axis.column) - names.begin());
  std::vector<double> values;
  for (const ElementRow& row : curve.rows) {
    const double water = axis.column == p_eff.column ? row.pore_pressure : 0.0;
    values.push_back(axis.unit * (element_numbers(row, curve.test, curve.water)[index] - water));
  }
  return values;
}

bool changes_across(const Series& series) {
  return std::ranges::any_of(series.x, [&](double x) { return x != series.x.front(); });
}

bool shows(const PictureOf& picture, const Table& table) {
  return table.has(picture.x.column) && table.has(picture.y.column);
}

} // namespace

std::vector<NamedPlot> element_plots(const std::vector<NamedCurve>& curves, const std::optional<Overlay>& overlay,
                                     const std::string& subject) {
  const std::string test = curves.front().curve.test;
  std::vector<NamedPlot> plots;
  for (const PictureOf& picture : pictures_of(test)) {
    Plot plot{.title = title_of(test) + subject,
              .x_label = picture.x.label,
              .y_label = picture.y.label,
              .series = {},
              .log_x = picture.log_x};
    for (const auto& [label, curve] : curves)
      plot.series.push_back({.label = label, .x = column_of(curve, picture.x), .y = column_of(curve, picture.y)});
    if (std::ranges::none_of(plot.series, changes_across)) continue; // no shear in a path without shear
    if (overlay && shows(picture, overlay->table))
      plot.series.push_back({.label = overlay->label,
                             .x = column_of(overlay->table, picture.x),
                             .y = column_of(overlay->table, picture.y),
                             .style = Style::dots,
                             .color = black});
    plots.push_back({picture.file, std::move(plot)});
  }
  return plots;
}

std::vector<std::string> draw_element(const std::vector<NamedCurve>& curves, const std::optional<Overlay>& overlay,
                                      const std::string& subject, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const NamedPlot& each : element_plots(curves, overlay, subject)) {
    write_png(folder / each.file, each.plot);
    names.push_back(each.file);
  }
  return names;
}

Overlay read_overlay(const std::filesystem::path& path, const std::string& test) {
  Overlay overlay{.label = path.filename().string(), .table = read_table(path)};
  std::string wanted;
  for (const PictureOf& picture : pictures_of(test)) {
    if (shows(picture, overlay.table)) return overlay;
    wanted += (wanted.empty() ? "" : "; or ") + picture.x.column + " and " + picture.y.column;
  }
  throw InputError(path.string() + ":1:1: has none of the pairs of columns that a picture shows: " + wanted);
}

} // namespace riedel
