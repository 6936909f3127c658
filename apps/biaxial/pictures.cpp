#include "apps/biaxial/pictures.hpp"

#include "core/draw/drawn_fields.hpp"
#include "core/draw/picture.hpp"
#include "core/draw/plot.hpp"

#include <cstdio>

namespace riedel {

namespace {

/// "gimp, l_c = 1.5 mm, 24×84 cells", in three dimensions "24×84×1 cells"
std::string title_of(const BiaxialCase& v) {
  const double length = v.nonlocal.length;
  const auto& cells = v.grid.cells;
  const std::string depth = v.grid.dimensions == 3 ? "×" + std::to_string(v.specimen.depth_cells) : "";
  return v.scheme + ", " + (length > 0 ? "l_c = " + plain_number(1e3 * length) + " mm" : "local") + ", " +
         std::to_string(cells[0]) + "×" + std::to_string(cells[1]) + depth + " cells";
}

Plot history_plot(const std::vector<BiaxialRow>& rows, const BiaxialCase& values) {
  Plot plot{.title = "Plane strain compression: " + title_of(values),
            .x_label = "u/h₀ [%]",
            .y_label = "mobilised friction angle φ [°]",
            .series = {{.label = "by the initial width", .x = {}, .y = {}},
                       {.label = "by the present width", .x = {}, .y = {}}}};
  for (const BiaxialRow& row : rows) {
    for (Series& series : plot.series) series.x.push_back(100.0 * row.u_over_h);
    plot.series[0].y.push_back(row.angle);
    plot.series[1].y.push_back(row.true_angle);
  }
  return plot;
}

} // namespace

std::vector<std::string> draw_biaxial(const std::vector<BiaxialRow>& rows, const Frame& section,
                                      const BiaxialCase& values, const std::filesystem::path& folder) {
  const Plot plot = history_plot(rows, values);
  write_png(folder / "history.png", plot);
  write_svg(folder / "history.svg", plot);
  std::vector<std::string> names{"history.png", "history.svg"};
  for (const DrawnField& field : drawn_fields) {
    if (!section.has(field.name)) continue;
    names.push_back(std::string(field.name) + ".png");
    write_field_picture(folder / names.back(), section,
                        {.field = field.name,
                         .component = field.component,
                         .unit = field.unit,
                         .title = title_of(values),
                         .subtitle = "u/h₀ = " + fixed_text(100.0 * section.scalar("u_over_h"), 2) + " %",
                         .label = field.label});
  }
  return names;
}

} // namespace riedel
