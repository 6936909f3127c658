#include "apps/reproduce/figures.hpp"

#include "apps/messages.hpp"
#include "apps/reproduce/band_theory.hpp"
#include "core/io/picture.hpp"

#include <algorithm>

namespace riedel {

namespace {

constexpr Color grey{0.5, 0.5, 0.5};

Series homogeneous_series(const HomogeneousTest& test, const std::string& label) {
  Series series{.label = label, .x = test.u_over_h, .y = test.angle, .style = Style::dotted, .color = grey};
  for (double& x : series.x) x *= 100.0;
  return series;
}

Series band_series(const Values& paper_case) {
  Series series{.label = "1-D band at 55°", .x = {}, .y = {}, .style = Style::dashed, .color = black};
  constexpr double step = 5e-4, last = 0.05; // as far as the reference goes
  for (double strain = step; strain <= std::min(last, paper_case.number("loading.final_strain")) + 1e-9;
       strain += step) {
    series.x.push_back(100.0 * strain);
    series.y.push_back(band_1d(strain).angle);
  }
  return series;
}

Plot with_theory(Plot plot, const PaperResults& results) {
  plot.series.push_back(homogeneous_series(results.homogeneous(0.55), "homogeneous"));
  plot.series.push_back(band_series(results.paper_case()));
  return plot;
}

std::vector<std::string> names_of_figure_7() {
  std::vector<std::string> names;
  for (const std::string& mesh : mesh_runs()) {
    names.push_back(mesh);
    names.push_back(with_fixed_step(mesh));
  }
  return names;
}

/// In Figure 8 the paper's case is one length, in Figure 10 one void ratio.
std::vector<RunResult> renamed(std::vector<RunResult> runs, const std::string& label) {
  for (RunResult& run : runs)
    if (run.name == paper_run) run.label = label;
  return runs;
}
std::vector<RunResult> runs_of_figure_8(const PaperResults& results) {
  return renamed(results.some(length_runs()), "l_c = 1.5 mm");
}
std::vector<RunResult> runs_of_figure_10(const PaperResults& results) {
  return renamed(results.some(density_runs()), "e₀ = 0.55");
}

/// None where a frame is damaged.
std::vector<PointCurve> readable_points(const RunResult& run, const Values& paper_case) {
  try {
    return points_in_and_out(run, paper_case);
  } catch (const std::exception& error) {
    print_warning(run.name + " has no void ratios of points: " + error.what());
    return {};
  }
}

Plot void_ratios(const PaperResults& results) {
  Plot plot{.title = "Void ratio outside (1 to 3) and inside (4 to 6) the band",
            .x_label = "u/h₀ [%]",
            .y_label = "void ratio e [-]",
            .series = {}};
  const RunResult* run = results.done(paper_run);
  if (run == nullptr) return plot;
  for (const PointCurve& curve : readable_points(*run, results.paper_case())) {
    Series series{.label = curve.name + ": x = " + with_digits(1e3 * curve.x, 0) +
                           ", y = " + with_digits(1e3 * curve.y, 0) + " mm",
                  .x = curve.u_over_h,
                  .y = curve.void_ratio};
    for (double& x : series.x) x *= 100.0;
    series.id = "point " + curve.name;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

} // namespace

std::vector<FigurePart> curve_figures(const PaperResults& results) {
  std::vector<FigurePart> parts;
  const Figures& figures = results.figures();
  if (figures.contains(7))
    parts.push_back({7, "7",
                     "Figure 7: three meshes, with the automatic time step and with 1e-6 s; theory beside them.",
                     with_theory(curves_of(results.some(names_of_figure_7()), "Meshes and time steps"), results)});
  if (figures.contains(8))
    parts.push_back({8, "8a", "Figure 8A: characteristic lengths.",
                     with_theory(curves_of(runs_of_figure_8(results), "Characteristic lengths"), results)});
  if (figures.contains(9))
    parts.push_back(
        {9, "9", "Figure 9: void ratios at six points, named by where they started.", void_ratios(results)});
  if (figures.contains(10)) {
    Plot plot = curves_of(runs_of_figure_10(results), "Initial void ratios");
    for (const double void_ratio : {0.55, 0.75, 0.90})
      plot.series.push_back(
          homogeneous_series(results.homogeneous(void_ratio), void_ratio == 0.55 ? "homogeneous" : ""));
    parts.push_back({10, "10a", "Figure 10: initial void ratios, and the homogeneous test of each.", std::move(plot)});
  }
  return parts;
}

std::vector<SpecimenFigure> specimen_figures(const PaperResults& results) {
  std::vector<SpecimenFigure> parts;
  if (results.figures().contains(8))
    parts.push_back({8, "8b", "Figure 8B: deformed specimens", runs_of_figure_8(results)});
  if (results.figures().contains(10))
    parts.push_back({10, "10b", "Figure 10: deformed specimens", runs_of_figure_10(results)});
  return parts;
}

std::vector<std::string> write_figures(const std::vector<FigurePart>& curves,
                                       const std::vector<SpecimenFigure>& specimens,
                                       const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const FigurePart& part : curves) {
    names.push_back("figure_" + part.name + ".png");
    write_png(folder / names.back(), part.plot);
  }
  for (const SpecimenFigure& part : specimens) {
    std::vector<Frame> frames;
    std::vector<std::string> labels;
    for (const RunResult& run : part.runs)
      if (auto frame = readable_frame(run, drawn_strain); frame && frame->has("void_ratio")) {
        frames.push_back(std::move(*frame));
        labels.push_back(run.label);
      }
    if (frames.empty()) continue;
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < frames.size(); ++i) panels.push_back({&frames[i], labels[i], ""});
    names.push_back("figure_" + part.name + ".png");
    write_field_pictures(folder / names.back(), panels,
                         {.field = "void_ratio",
                          .title = "",
                          .subtitle = "",
                          .label = "void ratio e [-], u/h₀ = " + with_digits(100 * drawn_strain, 0) + " %",
                          .range = field_range(frames, drawn_fields.front()),
                          .width = 2000,
                          .height = 900});
  }
  return names;
}

} // namespace riedel
