#include "apps/report/run_views.hpp"

#include "apps/figure_json.hpp"
#include "apps/messages.hpp"
#include "apps/section.hpp"
#include "core/base/error.hpp"
#include "core/io/field_image.hpp"
#include "core/io/vtk_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace riedel {

namespace {

using nlohmann::ordered_json;

const PageCell none{"–", "faint"};

/// A figure of a summary, or of the band in it, in its unit; a dash where there is none.
PageCell figure(const ordered_json& json, const char* name, double unit, int digits) {
  const double x = figure_in(json, name);
  return std::isnan(x) ? none : PageCell{with_digits(x / unit, digits)};
}

/// An object; empty where no band was found.
ordered_json band_of(const RunResult& run) {
  if (!run.summary.is_object() || !run.summary.contains("band")) return ordered_json::object();
  const ordered_json& band = run.summary.at("band");
  return text_in(band, "kind", "none") != "none" ? band : ordered_json::object();
}

/// The part of the summary on stresses; empty where a run has none.
ordered_json quality_of(const RunResult& run) {
  const bool has = run.summary.is_object() && run.summary.contains("stress");
  return has ? run.summary.at("stress") : ordered_json::object();
}

PageCell exponent(const ordered_json& json, const char* name) {
  const double x = figure_in(json, name);
  if (std::isnan(x)) return none;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", x);
  return {text.data()};
}

PageCell last_of(const RunResult& run, const char* column, int digits) {
  if (!run.history.has(column)) return none;
  return {with_digits(run.history[column].back(), digits)};
}

PageCell kind_of_band(const RunResult& run) {
  if (run.status != RunStatus::done) return {name_of(run.status), "faint"};
  const ordered_json& band = run.summary.at("band");
  return {text_in(band, "kind", "none") + (text_in(band, "doubt", "").empty() ? "" : ", doubtful")};
}

/// Between which all but `share` of the values lie.
Interval range_without_extremes(std::vector<double> values, double share) {
  std::erase_if(values, [](double x) { return !std::isfinite(x); });
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto at = [&](double part) { return values[static_cast<std::size_t>(part * double(values.size() - 1))]; };
  Extent extent;
  extent.add(at(share / 2));
  extent.add(at(1 - share / 2));
  return extent.interval(0.0);
}

} // namespace

std::string with_digits(double x, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, x);
  return text.data();
}

Plot curves_of(Runs runs, const std::string& title, const std::string& column) {
  Plot plot{.title = title, .x_label = "u/h₀ [%]", .y_label = "mobilised friction angle φ [°]", .series = {}};
  plot.width = 820;
  for (const RunResult& run : runs) {
    if (!run.history.has("u_over_h") || !run.history.has(column)) continue;
    Series series{.label = run.label, .x = run.history["u_over_h"], .y = run.history[column]};
    for (double& x : series.x) x *= 100.0;
    series.id = run.name;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

PageTable band_table(Runs runs) {
  PageTable table{.caption =
                      "Strength, and the shear band at the end of each run. t_s: thickness, by the void ratio as the "
                      "paper does it, and as the full width at half maximum of the rise of e, and of the rate ‖D‖. "
                      "Scatter: of the pressure about its local mean in the band, which no curve shows; above 10 % the "
                      "stresses there are unsound.",
                  .header = {"run", "φ peak [°]", "at u/h₀ [%]", "φ residual [°]", "band", "θ [°]", "t_s by e [mm]",
                             "t_s by e / l_c", "t_s half max. of e [mm]", "t_s half max. of ‖D‖ [mm]", "e inside",
                             "scatter of p [%]", "without stress"},
                  .rows = {}};
  for (const RunResult& run : runs) {
    const ordered_json band = band_of(run), quality = quality_of(run);
    table.rows.push_back({{{run.label},
                           figure(run.summary, "phi_peak_deg", 1.0, 2),
                           figure(run.summary, "u_over_h_at_peak", 0.01, 2),
                           figure(run.summary, "phi_residual_deg", 1.0, 1),
                           kind_of_band(run),
                           figure(band, "inclination_deg", 1.0, 1),
                           figure(band, "thickness_m", 1e-3, 2),
                           figure(band, "thickness_over_lc", 1.0, 1),
                           figure(band, "thickness_fwhm_m", 1e-3, 2),
                           figure(band, "thickness_rate_m", 1e-3, 2),
                           figure(band, "void_ratio_inside", 1.0, 3),
                           figure(quality, "pressure_scatter", 0.01, 1),
                           figure(quality, "stressless_in_band", 1.0, 0)},
                          run.name});
  }
  return table;
}

PageTable cost_table(Runs runs) {
  PageTable table{
      .caption = "Energies at the end, per metre of depth, and what the run took. Kinetic over internal energy: "
                 "the greatest value past u/h₀ = 0.5 %. Lost: what the nodes did not give back to the points; "
                 "open: what no account has.",
      .header = {"run", "internal [J/m]", "external [J/m]", "kinetic/internal", "lost/external [%]",
                 "open/external [%]", "mass error", "points", "steps", "wall time [s]", "ns per point and step"},
      .rows = {}};
  for (const RunResult& run : runs)
    table.rows.push_back({{{run.label},
                           last_of(run, "internal_J_per_m", 2),
                           last_of(run, "external_J_per_m", 2),
                           exponent(run.summary, "kinetic_over_internal_max"),
                           figure(run.summary, "transfer_over_external", 0.01, 2),
                           figure(run.summary, "unaccounted_over_external", 0.01, 3),
                           exponent(run.summary, "mass_error"),
                           figure(run.summary, "points", 1.0, 0),
                           figure(run.summary, "steps", 1.0, 0),
                           figure(run.summary, "wall_s", 1.0, 1),
                           figure(run.summary, "ns_per_point_step", 1.0, 0)},
                          run.name});
  return table;
}

PageTable settings_table(Runs runs) {
  PageTable table{.caption = "What the runs differ in.", .header = {"run"}, .rows = {}, .long_text = true};
  std::vector<std::string> keys;
  for (const RunResult& run : runs)
    for (const auto& [key, value] : run.settings)
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  table.header.insert(table.header.end(), keys.begin(), keys.end());
  table.header.emplace_back("status");
  for (const RunResult& run : runs) {
    PageRow row{{{run.label}}, run.name};
    for (const std::string& key : keys) {
      const auto found = std::ranges::find(run.settings, key, &Setting::first);
      row.cells.push_back(found == run.settings.end() ? none : PageCell{found->second});
    }
    row.cells.push_back({std::string(name_of(run.status)) + (run.reason.empty() ? "" : ": " + run.reason),
                         run.status == RunStatus::done ? "" : "differs"});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<double> history_at(const RunResult& run, const std::string& column, double u_over_h) {
  if (!run.history.has("u_over_h") || !run.history.has(column)) return std::nullopt;
  const std::vector<double>&x = run.history["u_over_h"], &y = run.history[column];
  constexpr double round_off = 1e-3; // the last row lies within a step of the final strain
  if (u_over_h < x.front() || u_over_h > x.back() * (1.0 + round_off)) return std::nullopt;
  const auto above = std::ranges::lower_bound(x, u_over_h);
  if (above == x.begin() || above == x.end()) return above == x.end() ? y.back() : y.front();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return std::lerp(y[i - 1], y[i], (u_over_h - x[i - 1]) / (x[i] - x[i - 1]));
}

std::optional<Frame> frame_at(const RunResult& run, double u_over_h) {
  const auto time = history_at(run, "time_s", u_over_h);
  const std::vector<FrameFile> files = frame_files(run.folder);
  if (!time || files.empty()) return std::nullopt;
  const auto distance = [&](const FrameFile& file) { return std::abs(file.time - *time); };
  Frame frame = read_frame(std::ranges::min_element(files, {}, distance)->path);
  if (frame.dimension == 2) return frame;
  if (!frame.has("displacement")) return std::nullopt; // it does not tell which points stood behind one another
  return mean_over_depth(frame, depth_of(frame));
}

std::optional<Frame> readable_frame(const RunResult& run, double u_over_h) {
  try {
    return frame_at(run, u_over_h);
  } catch (const std::exception& error) {
    print_warning(run.name + " has no picture: " + error.what());
    return std::nullopt;
  }
}

double common_strain(Runs runs) {
  double least = 1.0;
  for (const RunResult& run : runs)
    if (run.status == RunStatus::done) least = std::min(least, run.history["u_over_h"].back());
  return least;
}

Interval field_range(std::span<const Frame> frames, const DrawnField& field) {
  std::vector<double> values;
  for (const Frame& frame : frames) {
    const std::vector<double> more = FieldColors{field.name, field.component, {}, field.unit}.values(frame);
    values.insert(values.end(), more.begin(), more.end());
  }
  return range_without_extremes(std::move(values), 2e-3);
}

PagePictures field_pictures(Runs runs, const DrawnField& field, double u_over_h) {
  PagePictures all{.caption = "Specimens at u/h₀ = " + with_digits(100.0 * u_over_h, 1) + " %.",
                   .pictures = {},
                   .label = field.label,
                   .range = {}};
  std::vector<const RunResult*> shown;
  std::vector<Frame> frames;
  for (const RunResult& run : runs) {
    try {
      if (auto frame = frame_at(run, u_over_h); frame && frame->has(field.name)) {
        shown.push_back(&run);
        frames.push_back(std::move(*frame));
      }
    } catch (const std::exception& error) { all.caption += std::string(" No picture: ") + error.what() + "."; }
  }
  if (frames.empty()) return all;
  all.range = field_range(frames, field);
  std::vector<const Frame*> drawn;
  for (const Frame& frame : frames) drawn.push_back(&frame);
  const Box view = view_of(drawn);
  constexpr int height = 640;
  for (std::size_t i = 0; i < frames.size(); ++i)
    all.pictures.push_back({field_image(frames[i], {field.name, field.component, all.range, field.unit}, view, height),
                            shown[i]->label, shown[i]->name});
  all.width_px = static_cast<int>(0.5 * height * (view.right - view.left) / (view.top - view.bottom));
  return all;
}

} // namespace riedel
