#include "apps/reproduce/paper_results.hpp"

#include "apps/reproduce/band_theory.hpp"
#include "core/analysis/frame_measures.hpp"
#include "core/base/error.hpp"
#include "core/io/figure_json.hpp"
#include "core/io/vtk_reader.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>

namespace riedel {

namespace {
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
} // namespace

PaperResults::PaperResults(const std::vector<RunResult>& runs, Figures figures, const Values& paper_case, Way way)
    : figures_(std::move(figures)), case_(paper_case), way_(std::move(way)) {
  const auto is_of = [](const RunResult& run, const Way& one) {
    return one.suffix.empty() ? std::ranges::none_of(all_ways(),
                                                     [&](const Way& other) {
                                                       return !other.suffix.empty() && run.name.ends_with(other.suffix);
                                                     })
                              : run.name.ends_with(one.suffix);
  };
  std::ranges::copy_if(runs, std::back_inserter(runs_), [&](const RunResult& run) { return is_of(run, way_); });
  for (RunResult& run : runs_) // titles say it once for all
    if (run.label.ends_with(way_.suffix)) run.label.resize(run.label.size() - way_.suffix.size());
}

const RunResult* PaperResults::done(const std::string& name) const {
  const auto found = std::ranges::find(runs_, in_this_way(name), &RunResult::name);
  return found == runs_.end() || found->status != RunStatus::done ? nullptr : &*found;
}

std::vector<RunResult> PaperResults::some(const std::vector<std::string>& names) const {
  std::vector<RunResult> found;
  for (const std::string& name : names)
    if (const auto run = std::ranges::find(runs_, in_this_way(name), &RunResult::name); run != runs_.end())
      found.push_back(*run);
  return found;
}

double PaperResults::figure(const std::string& run, const std::string& name) const {
  const RunResult* result = done(run);
  if (result == nullptr) return nothing;
  const bool of_band = name.starts_with("band.");
  const nlohmann::ordered_json& from = of_band ? result->summary.at("band") : result->summary;
  if (of_band && !flag_in(from, "found")) return nothing;
  return figure_in(from, (of_band ? name.substr(5) : name).c_str());
}

double PaperResults::angle_at(const std::string& run, double u_over_h) const {
  const RunResult* result = done(run);
  return result == nullptr ? nothing : history_at(*result, "phi_mob_deg", u_over_h).value_or(nothing);
}

double PaperResults::true_angle_at(const std::string& run, double u_over_h) const {
  const RunResult* result = done(run);
  return result == nullptr ? nothing : history_at(*result, "phi_true_deg", u_over_h).value_or(nothing);
}

double PaperResults::dilatancy_at_peak(const std::string& run) const {
  const double peak = figure(run, "u_over_h_at_peak");
  if (!(peak > 0.0)) return nothing;
  constexpr double before = 0.003;
  const auto width = [&](double u_over_h) { // over the initial one: of one force
    const double present = true_angle_at(run, u_over_h), initial = angle_at(run, u_over_h);
    const auto ratio = [](double angle) {
      const double s = std::sin(angle * std::numbers::pi / 180.0);
      return (1.0 + s) / (1.0 - s);
    };
    return ratio(initial) / ratio(present);
  };
  const double shortened = std::log((1.0 - peak + before) / (1.0 - peak));
  const double widened = std::log(width(peak) / width(peak - before));
  return std::asin((widened - shortened) / (widened + shortened)) * 180.0 / std::numbers::pi;
}

double PaperResults::block_compression(const std::string& run, double u_over_h) const {
  const RunResult* result = done(run);
  const auto frame = result == nullptr ? std::nullopt : readable_frame(*result, u_over_h);
  const auto band = band_at(run, u_over_h);
  if (!frame || !band || !band->found || !frame->has("displacement")) return nothing;
  const std::vector<double>& moved = frame->field("displacement").values;
  double sum = 0.0;
  for (const double side : {-1.0, 1.0}) { // v = a + b X + c Y over the block, by least squares
    Eigen::Matrix3d of_places = Eigen::Matrix3d::Zero();
    Eigen::Vector3d of_moves = Eigen::Vector3d::Zero();
    for (std::size_t p = 0; p < frame->points(); ++p) {
      const Vec<2> x(frame->position[3 * p], frame->position[3 * p + 1]);
      if (side * band->line.across(x) < band->thickness_fwhm_m) continue;
      const Eigen::Vector3d place(1.0, x[0] - moved[3 * p], x[1] - moved[3 * p + 1]);
      of_places += place * place.transpose();
      of_moves += moved[3 * p + 1] * place;
    }
    sum -= 0.5 * of_places.ldlt().solve(of_moves)[2];
  }
  return sum;
}

double PaperResults::band_angle(const std::string& run, double u_over_h) const {
  const double theta = figure(run, "band.inclination_deg");
  return std::isnan(theta) ? nothing : band_1d_angle(u_over_h, theta);
}

double PaperResults::band_angle_at_equal_slip(const std::string& run, double u_over_h) const {
  const double slipped = u_over_h - block_compression(run, u_over_h), theta = figure(run, "band.inclination_deg");
  if (std::isnan(slipped) || std::isnan(theta)) return nothing;
  constexpr double peak_of_band = 0.0139, end_of_band = 0.0499, step = 1e-5; // of the rows of band_1d
  const Unloading back = unloading_after(case_.section("material"), case_.number("specimen.void_ratio"),
                                         case_.number("loading.confining_pressure"), peak_of_band);
  for (double strain = peak_of_band; strain < end_of_band; strain += step) {
    const auto at = std::ranges::lower_bound(back.angle, band_1d(strain).angle, std::greater{});
    if (at == back.angle.end()) return nothing;
    if (strain - back.u_over_h[static_cast<std::size_t>(at - back.angle.begin())] >= slipped)
      return band_1d_angle(strain, theta);
  }
  return nothing;
}

double PaperResults::distance(const std::string& a, const std::string& b, double from, double to) const {
  double maximum = 0.0;
  constexpr double step = 5e-4;
  for (double strain = from; strain <= to; strain += step) {
    const double apart = std::abs(angle_at(a, strain) - angle_at(b, strain));
    if (std::isnan(apart)) return nothing;
    maximum = std::max(maximum, apart);
  }
  return maximum;
}

std::optional<ShearBand> PaperResults::band_at(const std::string& run, double u_over_h) const {
  const RunResult* result = done(run);
  if (result == nullptr) return std::nullopt;
  BandSettings settings{.length = case_.number("nonlocal.length"), .threshold = case_.number("output.band_void_ratio")};
  for (const auto& [key, value] : result->settings)
    if (key == "nonlocal.length") settings.length = std::stod(value);
  const auto frame = readable_frame(*result, u_over_h);
  return frame ? std::optional(measure_band(*frame, settings)) : std::nullopt;
}

double PaperResults::dilation_above(const std::string& run, double u_over_h) const {
  const RunResult* result = done(run);
  const auto frame = result == nullptr ? std::nullopt : readable_frame(*result, u_over_h);
  if (!frame || !frame->has("volume") || !frame->has("volume_ratio")) return nothing;
  const std::vector<double>& volume = frame->field("volume").values;
  std::vector<double> growth = frame->field("volume_ratio").values; // grains keep their volume
  std::vector<double> sorted = growth;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double median = sorted[sorted.size() / 2], middle = 0.5 * case_.number("specimen.height") * (1.0 - u_over_h);
  double above = 0.0, all = 0.0;
  for (std::size_t p = 0; p < growth.size(); ++p) {
    const double more = volume[p] * std::max(growth[p] - median, 0.0);
    all += more;
    if (frame->position[3 * p + 1] > middle) above += more;
  }
  return above / all;
}

const HomogeneousTest& PaperResults::homogeneous(double void_ratio) const {
  const auto known = homogeneous_.find(void_ratio);
  if (known != homogeneous_.end()) return known->second;
  return homogeneous_
      .emplace(void_ratio,
               homogeneous_test(case_.section("material"), void_ratio, case_.number("loading.confining_pressure"),
                                case_.number("loading.final_strain")))
      .first->second;
}

std::vector<PointCurve> points_in_and_out(const RunResult& run, const Values& v) {
  const std::vector<FrameFile> files = frame_files(run.folder);
  if (files.empty() || files.front().path.extension() != ".vtp") return {};
  const Frame first = deformable_points(read_frame(files.front().path)),
              last = deformable_points(read_frame(files.back().path));
  const auto require_same_points = [&](const Frame& frame, const FrameFile& file) {
    if (frame.points() != first.points()) throw InputError(file.path.string() + ": is of another run");
  };
  require_same_points(last, files.back());
  const double width = v.number("specimen.width"), height = v.number("specimen.height");
  const std::vector<double>& e = last.field("void_ratio").values;
  const auto start = [&](std::size_t p) { return Vec<2>(first.position[3 * p], first.position[3 * p + 1]); };

  std::vector<std::size_t> outside, inside; // a point keeps its number from frame to frame
  for (const double column : {0.3, 0.5, 0.7}) {
    std::size_t loosest = 0;
    double nearest = width;
    for (std::size_t p = 0; p < first.points(); ++p)
      nearest = std::min(nearest, std::abs(start(p)[0] - column * width));
    const auto in_column = [&](std::size_t p) { return std::abs(start(p)[0] - column * width) < nearest + 1e-9; };
    for (std::size_t p = 0; p < first.points(); ++p)
      if (in_column(p) && (!in_column(loosest) || e[p] > e[loosest])) loosest = p;
    const double from_platen = 0.02, y = start(loosest)[1] > 0.5 * height ? from_platen : height - from_platen;
    std::size_t far = loosest;
    for (std::size_t p = 0; p < first.points(); ++p)
      if (in_column(p) && std::abs(start(p)[1] - y) < std::abs(start(far)[1] - y)) far = p;
    outside.push_back(far);
    inside.push_back(loosest);
  }

  std::vector<PointCurve> curves;
  for (const auto* points : {&outside, &inside})
    for (const std::size_t p : *points)
      curves.push_back({.name = std::to_string(curves.size() + 1),
                        .x = start(p)[0],
                        .y = start(p)[1],
                        .u_over_h = {},
                        .void_ratio = {},
                        .pressure = last.field("mean_pressure").values[p]});
  for (const FrameFile& file : files) {
    const Frame frame = deformable_points(read_frame(file.path));
    require_same_points(frame, file);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const std::size_t p = k < outside.size() ? outside[k] : inside[k - outside.size()];
      curves[k].u_over_h.push_back(frame.scalar("u_over_h"));
      curves[k].void_ratio.push_back(frame.field("void_ratio").values[p]);
    }
  }
  return curves;
}

} // namespace riedel
