#include "apps/biaxial/record.hpp"

#include "apps/biaxial/geometry.hpp"
#include "core/analysis/depth_mean.hpp"
#include "core/io/figure_json.hpp"
#include "core/step/boundaries/velocity_course.hpp"

#include <numeric>

namespace riedel {

namespace {
const std::vector<std::string> columns{"step",
                                       "time_s",
                                       "u_over_h",
                                       "phi_mob_deg",
                                       "force_N_per_m",
                                       "kinetic_J_per_m",
                                       "internal_J_per_m",
                                       "external_J_per_m",
                                       "time_step_s",
                                       "substepped",
                                       "low_pressure",
                                       "separated",
                                       "out_of_bounds",
                                       "phi_true_deg",
                                       "filter_J_per_m",
                                       "alternation",
                                       "stressless",
                                       "block_velocity_m_per_s",
                                       "transfer_J_per_m"};
constexpr double swing_part = 0.01; ///< u/h0 at the end of a run over which the blocks' velocity is evaluated
} // namespace

template <int Dim>
BiaxialRun<Dim>::BiaxialRun(const BiaxialCase& values, const Catalogue& catalogue, std::filesystem::path folder,
                            Stepper stepper)
    : values_(values),
      depth_(specimen_depth(values)),
      simulation_(make_biaxial<Dim>(values, catalogue)),
      speed_(ramped(values.loading.speed, values.loading.ramp_time)),
      start_(places_of(simulation_)),
      folder_(std::move(folder)),
      loop_(simulation_, std::move(stepper)) {
  if (values.output.vtk) series_.emplace(folder_);
  const auto strain = [this] { return u_over_h(); };
  loop_.after_steps(1, [this] { add_up_force(); });
  loop_.every(values.output.every_strain, strain, [this] { add_row(); });
  loop_.every(values.output.frames_every_strain, strain, [this] { add_frame(); });
  loop_.until("final strain", [this] { return u_over_h() >= values_.loading.final_strain; });
}

template <int Dim>
void BiaxialRun<Dim>::begin() {
  history_.emplace(folder_ / "history.csv", columns);
  loop_.begin();
}

template <int Dim>
void BiaxialRun<Dim>::advance(const std::function<bool()>& stop, const std::function<void(const BiaxialRow&)>& at_row) {
  at_row_ = at_row;
  loop_.until("stop", stop);
  loop_.go();
  loop_.finish();
}

template <int Dim>
void BiaxialRun<Dim>::add_up_force() {
  const double dt = simulation_.time_step();
  u_ += speed_(simulation_.state().time) * dt;
  impulse_ += platen_impulse(simulation_, values_);
  impulse_time_ += dt;
}

template <int Dim>
void BiaxialRun<Dim>::add_row() {
  const State<Dim>& state = simulation_.state();
  const double at_rest = values_.loading.confining_pressure * values_.specimen.width;
  BiaxialRow row{.step = state.step, .time = state.time, .u_over_h = u_over_h()};
  row.force = impulse_time_ > 0.0 ? impulse_ / impulse_time_ : at_rest;
  row.angle = mobilised_angle(row.force, values_);
  const Energies energies = simulation_.energies();
  row.energies = {.kinetic = energies.kinetic / depth_,
                  .internal = energies.internal / depth_,
                  .external = energies.external / depth_,
                  .transfer = energies.transfer / depth_,
                  .filter = energies.filter / depth_,
                  .unaccounted = energies.unaccounted / depth_};
  row.time_step = simulation_.time_step();
  row.report = state.report;
  row.out_of_bounds = simulation_.out_of_bounds();
  row.true_angle = true_angle(row.force, present_width(state.bodies.front().points, values_), values_);
  row.quality = cheap_quality(state.bodies.front(), rows_of_points());
  history_->add(std::array{
      static_cast<double>(row.step), row.time, row.u_over_h, row.angle, row.force, row.energies.kinetic,
      row.energies.internal, row.energies.external, row.time_step, static_cast<double>(row.report.substepped),
      static_cast<double>(row.report.low_pressure), static_cast<double>(row.report.separated),
      static_cast<double>(row.out_of_bounds), row.true_angle, row.energies.filter, row.quality.alternation,
      static_cast<double>(row.quality.stressless), row.quality.block_velocity, row.energies.transfer});
  rows_.push_back(row);
  impulse_ = impulse_time_ = 0.0;
  kinetic_.record(row.u_over_h, row.energies);
  time_step_.record(simulation_);
  if (at_row_) at_row_(row);
}

template <int Dim>
SpecimenRows BiaxialRun<Dim>::rows_of_points() const {
  const auto [in_row, in_layer] = PointRows(values_);
  return {.in_row = in_row,
          .in_layer = in_layer,
          .across = Turn(values_).rotation.col(0),
          .void_ratio = values_.specimen.void_ratio,
          .pressure = values_.loading.confining_pressure};
}

template <int Dim>
void BiaxialRun<Dim>::add_frame() {
  if (series_) series_->write(frame());
}

template <int Dim>
Frame BiaxialRun<Dim>::frame() const {
  return snapshot(simulation_, start_, {{"u_over_h", u_over_h()}});
}

template <int Dim>
Frame BiaxialRun<Dim>::section() const {
  if constexpr (Dim == 2) return frame();
  return mean_over_depth(frame(), depth_);
}

template <int Dim>
double BiaxialRun<Dim>::residual_angle(double u_over_h_at_peak) const {
  constexpr double residual_part = 0.01; // u/h0
  const double end = rows_.back().u_over_h;
  if (u_over_h() < values_.loading.final_strain || end - u_over_h_at_peak < residual_part) return std::nan("");
  double sum = 0.0, counted = 0.0;
  for (const BiaxialRow& row : rows_)
    if (row.u_over_h > end - residual_part) sum += row.angle, counted += 1.0;
  return sum / counted;
}

template <int Dim>
nlohmann::ordered_json BiaxialRun<Dim>::summary() const {
  const State<Dim>& state = simulation_.state();
  const Points<Dim>& points = state.bodies.front().points;
  const auto peak = std::ranges::max_element(rows_, {}, &BiaxialRow::angle);
  const bool moved = state.step > 0;
  const auto once_moved = [&](double x) { return figure_json(moved ? x : std::nan("")); };
  const auto of_external = [&](double Energies::*energy) {
    const Energies& last = rows_.back().energies;
    return once_moved(last.*energy / last.external);
  };
  const double mass = std::accumulate(points.mass[0], points.mass[0] + points.size(), 0.0);
  double mass_on_grid = 0.0;
  for (const NodeSums<Dim>& node : state.nodes.sums) mass_on_grid += node.mass;
  return {{"scheme", values_.scheme},
          {"material", values_.material.model},
          {"points", points.size()},
          {"nodes", state.nodes.size()},
          {"steps", state.step},
          {"time_s", state.time},
          {"u_over_h", u_over_h()},
          {"final_strain", values_.loading.final_strain},
          {"dt_s", once_moved(state.time / static_cast<double>(state.step))},
          {"phi_peak_deg", once_moved(peak->angle)},
          {"u_over_h_at_peak", once_moved(peak->u_over_h)},
          {"phi_residual_deg", figure_json(residual_angle(peak->u_over_h))},
          {"phi_true_peak_deg", once_moved(std::ranges::max(rows_, {}, &BiaxialRow::true_angle).true_angle)},
          {"phi_true_end_deg", once_moved(rows_.back().true_angle)},
          {"kinetic_over_internal_max", figure_json(kinetic_over_internal())},
          {"transfer_over_external", of_external(&Energies::transfer)},
          {"filter_over_external", of_external(&Energies::filter)},
          {"unaccounted_over_external", of_external(&Energies::unaccounted)},
          {"mass_error", once_moved(mass_on_grid / mass - 1.0)},
          {"evaluated_twice", state.report.evaluated_twice},
          {"substepped", state.report.substepped},
          {"substeps", state.report.substeps},
          {"rejected_substeps", state.report.rejected_substeps},
          {"low_pressure", state.report.low_pressure},
          {"separated", state.report.separated},
          {"out_of_bounds", simulation_.out_of_bounds()}};
}

template <int Dim>
nlohmann::ordered_json BiaxialRun<Dim>::quality() const {
  std::vector<double> u, velocity;
  for (const BiaxialRow& row : rows_)
    if (row.u_over_h > u_over_h() - swing_part)
      u.push_back(row.u_over_h), velocity.push_back(row.quality.block_velocity);
  const CheapQuality& last = rows_.back().quality;
  return {{"column_alternation", last.alternation},
          {"stressless", last.stressless},
          {"block_velocity_swing", figure_json(swing(u, velocity))}};
}

template class BiaxialRun<2>;
template class BiaxialRun<3>;

} // namespace riedel
