/// The biaxial test while it runs: advances it, and records and reports its results.
#pragma once

#include "apps/biaxial/specimen.hpp"
#include "core/analysis/cheap_quality.hpp"
#include "core/io/history.hpp"
#include "core/io/snapshot.hpp"
#include "core/io/vtk_writer.hpp"
#include "core/run/run.hpp"
#include "core/run/watches.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace riedel {

/// One row of history.csv, per metre of depth. Forces and angles are means since the row before.
struct BiaxialRow {
  std::int64_t step = 0;
  double time = 0, u_over_h = 0, angle = 0, force = 0; ///< [s], [-], [deg], [N/m]
  Energies energies{};                                 ///< [J/m]
  double time_step = 0;                                ///< [s]
  MaterialReport report{};
  std::int64_t out_of_bounds = 0;
  double true_angle = 0; ///< by the present width [deg]
  CheapQuality quality{};
};

template <int Dim>
class BiaxialRun {
public:
  using Stepper = typename Run<Dim>::Stepper;

  /// Makes the specimen; only the subfolders for frames are created in the folder. Throws InputError or RunError.
  /// @param stepper runs a step, on as many threads as it chooses
  BiaxialRun(
      const BiaxialCase& values, const Catalogue& catalogue, std::filesystem::path folder,
      Stepper stepper = [](const auto& step) { step(); });
  BiaxialRun(const BiaxialRun&) = delete;
  BiaxialRun& operator=(const BiaxialRun&) = delete;

  /// Writes the first row and frame. Throws RunError.
  void begin();
  /// Continues to the final strain, or until `stop()` is true between two steps, and ends with a row and a frame.
  /// Throws RunError.
  void advance(const std::function<bool()>& stop, const std::function<void(const BiaxialRow&)>& at_row);

  [[nodiscard]] const Simulation<Dim>& simulation() const { return simulation_; }
  [[nodiscard]] const std::vector<BiaxialRow>& rows() const { return rows_; }
  [[nodiscard]] double u_over_h() const { return u_ / values_.specimen.height; }
  [[nodiscard]] Frame frame() const;   ///< the present
  [[nodiscard]] Frame section() const; ///< the same in the plane: the mean over the depth
  /// Kinetic over internal energy, the maximum after u/h0 = 0.5 %; not a number for a run that has not reached it [-].
  [[nodiscard]] double kinetic_over_internal() const { return kinetic_.maximum(); }
  [[nodiscard]] const TimeStepWatch& time_step() const { return time_step_; }
  /// The entries of summary.json that the run itself knows; null for those without a value.
  [[nodiscard]] nlohmann::ordered_json summary() const;
  /// The part of `stress` in summary.json that does not depend on the band.
  [[nodiscard]] nlohmann::ordered_json quality() const;

private:
  /// Mean over the last 1 % of u/h0, for a run that has reached its final strain and whose peak lies before [deg].
  [[nodiscard]] double residual_angle(double u_over_h_at_peak) const;
  [[nodiscard]] SpecimenRows rows_of_points() const;
  void add_up_force();
  void add_row();
  void add_frame();

  const BiaxialCase& values_;
  double depth_; ///< 1 in two dimensions [m]
  Simulation<Dim> simulation_;
  std::function<double(double)> speed_;
  StartPlaces<Dim> start_;
  std::filesystem::path folder_;
  std::optional<History> history_;
  std::optional<SeriesWriter> series_;
  Run<Dim> loop_;
  std::vector<BiaxialRow> rows_;
  std::function<void(const BiaxialRow&)> at_row_;
  KineticShare kinetic_;
  TimeStepWatch time_step_;
  double u_ = 0.0;                            ///< displacement of the platen [m]
  double impulse_ = 0.0, impulse_time_ = 0.0; ///< ∫ force dt since the last row [N s/m], and over what time [s]
};

} // namespace riedel
