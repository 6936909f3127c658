#include "apps/reproduce/figures.hpp"

#include "apps/kinds.hpp"
#include "apps/reproduce/band_theory.hpp"
#include "core/draw/picture.hpp"
#include "core/io/messages.hpp"

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
    if (run.name.starts_with(paper_run)) run.label = label;
  return runs;
}
std::vector<RunResult> runs_of_figure_8(const PaperResults& results) {
  return renamed(results.some(length_runs()), "l_c = 1.5 mm");
}
std::vector<RunResult> runs_of_figure_10(const PaperResults& results) {
  return renamed(results.some(density_runs()), "e₀ = 0.55");
}

/// Empty if a frame is damaged.
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
    Series series{.label = curve.name + ": x = " + fixed_text(1e3 * curve.x, 0) +
                           ", y = " + fixed_text(1e3 * curve.y, 0) + " mm",
                  .x = curve.u_over_h,
                  .y = curve.void_ratio};
    for (double& x : series.x) x *= 100.0;
    series.id = "point " + curve.name;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// Ranges reported for tests, none of which could be checked in the original publications.
constexpr double mean_grain = 0.5e-3, min_grains = 10.0, max_grains = 20.0; // [m], [-], [-]
const std::string unchecked = "literature, unchecked";

Series marks(const PaperResults& results, const std::string& what, Marker marker) {
  return {.label = what + ", " + results.way().title, .x = {}, .y = {}, .style = Style::dots, .marker = marker};
}

FigurePart thickness_figure(const std::vector<PaperResults>& ways) {
  Plot plot{.title = "Thickness of the band",
            .x_label = "characteristic length l_c [mm]",
            .y_label = "thickness t_s [mm]",
            .series = {}};
  for (const PaperResults& results : ways) {
    Series by_e = marks(results, "half maximum of e", Marker::disc);
    Series by_rate = marks(results, "half maximum of ‖D‖", Marker::diamond);
    for (std::size_t i = 0; i < lengths().size(); ++i)
      if (lengths()[i] > 0.0)
        for (const auto& [series, figure] :
             {std::pair{&by_e, "band.thickness_fwhm_m"}, {&by_rate, "band.thickness_rate_m"}}) {
          series->x.push_back(1e3 * lengths()[i]);
          series->y.push_back(1e3 * results.figure(length_runs()[i], figure));
        }
    plot.series.push_back(std::move(by_e));
    plot.series.push_back(std::move(by_rate));
  }
  const Interval grains{1e3 * min_grains * mean_grain, 1e3 * max_grains * mean_grain};
  plot.x_range = Interval{0.0, 4.5};
  plot.y_range = Interval{0.0, 25.0};
  plot.shaded = {{{0.0, 4.5}, grains, "10 to 20 d50 of 0.5 mm (" + unchecked + ")"}};
  return {
      8, "8c",
      "Thickness against the characteristic length. Grey: values reported for plane strain tests on sands, 10 to 20 "
      "mean grain diameters, quoted from memory and not checked in the original publications; the paper gives no "
      "measured value.",
      std::move(plot)};
}

FigurePart inclination_figure(const std::vector<PaperResults>& ways) {
  Plot plot{.title = "Inclination of the band",
            .x_label = "initial void ratio e₀ [-]",
            .y_label = "θ to the horizontal [°]",
            .series = {}};
  const std::vector<double> void_ratios{0.55, 0.75}; // no band in the loosest
  for (const PaperResults& results : ways) {
    Series measured = marks(results, "θ", Marker::disc);
    for (std::size_t i = 0; i < void_ratios.size(); ++i) {
      measured.x.push_back(void_ratios[i]);
      measured.y.push_back(results.figure(density_runs()[i], "band.inclination_deg"));
    }
    plot.series.push_back(std::move(measured));
  }
  const PaperResults& last = ways.back();
  Series arthur{.label = "45° + (φ + ψ)/4", .x = {}, .y = {}, .style = Style::dots, .color = grey};
  arthur.marker = Marker::cross;
  for (std::size_t i = 0; i < void_ratios.size(); ++i) {
    const std::string run = density_runs()[i];
    const BandAngles angles = band_angles(last.figure(run, "phi_peak_deg"), last.dilatancy_at_peak(run));
    if (std::isnan(angles.arthur)) continue;
    constexpr double half = 0.04;
    arthur.x.push_back(void_ratios[i]);
    arthur.y.push_back(angles.arthur);
    plot.shaded.push_back(
        {{void_ratios[i] - half, void_ratios[i] + half}, {angles.roscoe, angles.coulomb}, "Roscoe to Coulomb"});
  }
  plot.series.push_back(std::move(arthur));
  plot.x_range = Interval{0.5, 0.85};
  plot.y_range = Interval{40.0, 80.0};
  return {
      10, "10c",
      "Inclination at the end against the initial void ratio. Grey: from Roscoe's 45° + ψ/2 to Coulomb's 45° + φ/2, "
      "with φ and ψ of the run (" +
          last.way().title + ") at its peak. For tests, 55 to 65° are reported (" + unchecked + ").",
      std::move(plot)};
}

} // namespace

std::vector<FigurePart> experiment_figures(const std::vector<PaperResults>& ways) {
  std::vector<FigurePart> parts;
  if (ways.front().figures().contains(8)) parts.push_back(thickness_figure(ways));
  if (ways.front().figures().contains(10)) parts.push_back(inclination_figure(ways));
  return parts;
}

std::vector<FigurePart> curve_figures(const PaperResults& results) {
  std::vector<FigurePart> parts;
  const Figures& figures = results.figures();
  const std::string file = results.filtered() ? "_filtered" : "";
  const std::string way = ", " + results.way().title + (results.filtered() ? "; by the present width." : ".");
  const auto curves = [&](const std::vector<RunResult>& runs, const std::string& title) {
    CurveAxes axes = run_kind("biaxial").axes(CaseFile::empty());
    if (results.filtered()) axes.y = "phi_true_deg";
    return curves_of(runs, title + ", " + results.way().title, axes);
  };
  if (figures.contains(7))
    parts.push_back({7, "7" + file,
                     "Figure 7: three meshes, with the automatic time step and with 1e-6 s, and theory" + way,
                     with_theory(curves(results.some(names_of_figure_7()), "Meshes and time steps"), results)});
  if (figures.contains(8))
    parts.push_back({8, "8a" + file, "Figure 8A: characteristic lengths" + way,
                     with_theory(curves(runs_of_figure_8(results), "Characteristic lengths"), results)});
  if (figures.contains(9))
    parts.push_back(
        {9, "9" + file,
         "Figure 9: void ratios at six points, named by their initial positions, " + results.way().title + ".",
         void_ratios(results)});
  if (figures.contains(10)) {
    Plot plot = curves(runs_of_figure_10(results), "Initial void ratios");
    for (const double void_ratio : {0.55, 0.75, 0.90})
      plot.series.push_back(
          homogeneous_series(results.homogeneous(void_ratio), void_ratio == 0.55 ? "homogeneous" : ""));
    parts.push_back(
        {10, "10a" + file, "Figure 10: initial void ratios, and the homogeneous test of each" + way, std::move(plot)});
  }
  return parts;
}

std::vector<SpecimenFigure> specimen_figures(const PaperResults& results) {
  std::vector<SpecimenFigure> parts;
  const std::string file = results.filtered() ? "_filtered" : "", way = ", " + results.way().title;
  if (results.figures().contains(8))
    parts.push_back({8, "8b" + file, "Figure 8B: deformed specimens" + way, runs_of_figure_8(results)});
  if (results.figures().contains(10))
    parts.push_back({10, "10b" + file, "Figure 10: deformed specimens" + way, runs_of_figure_10(results)});
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
    std::vector<const RunResult*> runs;
    for (const RunResult& run : part.runs) runs.push_back(&run);
    for (const DrawnField& field : pictured_fields) {
      const auto [frames, labels] = frames_with(field, runs, drawn_strain);
      if (frames.empty()) continue;
      std::vector<Panel> panels;
      for (std::size_t i = 0; i < frames.size(); ++i) panels.push_back({&frames[i], labels[i], ""});
      const bool first = &field == &pictured_fields.front();
      names.push_back("figure_" + part.name + (first ? "" : "_" + std::string(field.name)) + ".png");
      write_field_pictures(folder / names.back(), panels,
                           {.field = field.name,
                            .component = field.component,
                            .unit = field.unit,
                            .title = "",
                            .subtitle = "",
                            .label = field_label(field, drawn_strain, 0),
                            .range = field_range(frames, field),
                            .width = 2000,
                            .height = 900});
    }
  }
  return names;
}

} // namespace riedel
