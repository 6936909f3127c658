#include "apps/element/pictures.hpp"

#include "apps/element/tests/tests.hpp"
#include "core/base/error.hpp"

#include <algorithm>

namespace riedel {

namespace {

/// The pictures of the test; for a path, those of any compression and of shear.
std::vector<ElementPicture> pictures_of(const std::string& test) {
  if (const ElementTest* named = find_element_test(test)) return named->pictures;
  std::vector<ElementPicture> all = pictures_of_compression();
  all.push_back({"shear.png", picture_axes::gamma(), picture_axes::tau()});
  return all;
}

std::string title_of(const std::string& test) {
  const ElementTest* const named = find_element_test(test);
  return named == nullptr ? "Path" : named->title;
}

/// A measured column; an effective pressure does not include the pore pressure.
std::vector<double> column_of(const Table& table, const PictureAxis& axis) {
  std::vector<double> values = table[axis.column];
  if (axis.column == picture_axes::p().column && table.has("pore_pressure_Pa"))
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= table["pore_pressure_Pa"][i];
  for (double& value : values) value *= axis.unit;
  return values;
}

std::vector<double> column_of(const ElementCurve& curve, const PictureAxis& axis) {
  const std::vector<std::string> names = element_columns(shears(curve.test), curve.water);
  const auto index = static_cast<std::size_t>(std::ranges::find(names, axis.column) - names.begin());
  std::vector<double> values;
  for (const ElementRow& row : curve.rows) {
    const double water = axis.column == picture_axes::p().column ? row.pore_pressure : 0.0;
    values.push_back(axis.unit * (element_numbers(row, shears(curve.test), curve.water)[index] - water));
  }
  return values;
}

bool changes_across(const Series& series) {
  return std::ranges::any_of(series.x, [&](double x) { return x != series.x.front(); });
}

bool shows(const ElementPicture& picture, const Table& table) {
  return table.has(picture.x.column) && table.has(picture.y.column);
}

} // namespace

std::vector<NamedPlot> element_plots(const std::vector<NamedCurve>& curves, const std::optional<Overlay>& overlay,
                                     const std::string& subject) {
  const std::string test = curves.front().curve.test;
  std::vector<NamedPlot> plots;
  for (const ElementPicture& picture : pictures_of(test)) {
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
  for (const ElementPicture& picture : pictures_of(test)) {
    if (shows(picture, overlay.table)) return overlay;
    wanted += (wanted.empty() ? "" : "; or ") + picture.x.column + " and " + picture.y.column;
  }
  throw InputError(path.string() + ":1:1: has none of the pairs of columns that a picture shows: " + wanted);
}

} // namespace riedel
