#include "apps/biaxial_pictures.hpp"

#include "core/io/picture.hpp"
#include "core/io/plot.hpp"

#include <cstdio>

namespace riedel {

namespace {

std::string with_digits(double x, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, x);
  return text.data();
}

/// "gimp, l_c = 1.5 mm, 24×84"
std::string title_of(const Values& v) {
  const double length = v.number("nonlocal.length");
  const auto& cells = v.integers("grid.cells");
  return v.text("scheme") + ", " + (length > 0 ? "l_c = " + with_digits(1e3 * length, 2) + " mm" : "local") + ", " +
         std::to_string(cells[0]) + "×" + std::to_string(cells[1]) + " cells";
}

Plot history_plot(const BiaxialRun& run, const Values& values) {
  Plot plot{.title = "Plane strain compression: " + title_of(values),
            .x_label = "u/h₀ [%]",
            .y_label = "mobilised friction angle φ [°]",
            .series = {{.label = "", .x = {}, .y = {}}}};
  for (const BiaxialRow& row : run.rows()) {
    plot.series[0].x.push_back(100.0 * row.u_over_h);
    plot.series[0].y.push_back(row.angle);
  }
  return plot;
}

} // namespace

std::vector<std::string> draw_biaxial(const BiaxialRun& run, const Values& values,
                                      const std::filesystem::path& folder) {
  const Plot plot = history_plot(run, values);
  write_png(folder / "history.png", plot);
  write_svg(folder / "history.svg", plot);

  const Frame frame = run.frame();
  PictureOptions options{.field = "shear_strain",
                         .title = title_of(values),
                         .subtitle = "u/h₀ = " + with_digits(100.0 * run.u_over_h(), 2) + " %",
                         .label = "shear strain γ [-]"};
  write_field_picture(folder / "shear_strain.png", frame, options);
  std::vector<std::string> names{"history.png", "history.svg", "shear_strain.png"};
  if (state_column(run.simulation().state().bodies.front().material->states(), "void_ratio") < 0) return names;
  options.field = "void_ratio";
  options.label = "void ratio e [-]";
  write_field_picture(folder / "void_ratio.png", frame, options);
  names.push_back("void_ratio.png");
  return names;
}

} // namespace riedel
