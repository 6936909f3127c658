#include "core/campaign/run_views.hpp"

#include "core/analysis/depth_mean.hpp"
#include "core/base/error.hpp"
#include "core/draw/field_image.hpp"
#include "core/io/figure_json.hpp"
#include "core/io/messages.hpp"
#include "core/io/vtk_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace riedel {

namespace {

const PageCell none{"–", "faint"};

/// The interval that contains all but `share` of the values.
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

Plot curves_of(Runs runs, const std::string& title, const CurveAxes& axes) {
  Plot plot{.title = title, .x_label = axes.x_label, .y_label = axes.y_label, .series = {}};
  plot.width = 820;
  for (const RunResult& run : runs) {
    if (!run.history.has(axes.x) || !run.history.has(axes.y)) continue;
    Series series{.label = run.label, .x = run.history[axes.x], .y = run.history[axes.y]};
    for (double& x : series.x) x *= 100.0;
    series.id = run.name;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::optional<double> history_at(const RunResult& run, const std::string& column, double u_over_h) {
  if (!run.history.has("u_over_h") || !run.history.has(column)) return std::nullopt;
  const std::vector<double>&x = run.history["u_over_h"], &y = run.history[column];
  constexpr double round_off = 1e-3; // the last row is within one step of the final strain
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
  if (!frame.has("displacement")) return std::nullopt; // without it the points behind one another are unknown
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

LabelledFrames frames_with(const DrawnField& field, std::span<const RunResult* const> runs, double u_over_h) {
  LabelledFrames all;
  for (const RunResult* run : runs)
    if (auto frame = readable_frame(*run, u_over_h); frame && frame->has(field.name)) {
      all.frames.push_back(std::move(*frame));
      all.labels.push_back(run->label);
    }
  return all;
}

std::string field_label(const DrawnField& field, double u_over_h, int digits) {
  return std::string(field.label) + ", u/h₀ = " + fixed_text(100.0 * u_over_h, digits) + " %";
}

double common_strain(Runs runs) {
  double minimum = 1.0;
  for (const RunResult& run : runs)
    if (run.status == RunStatus::done) minimum = std::min(minimum, run.history["u_over_h"].back());
  return minimum;
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
  PagePictures all{.caption = "Specimens at u/h₀ = " + fixed_text(100.0 * u_over_h, 1) + " %.",
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
