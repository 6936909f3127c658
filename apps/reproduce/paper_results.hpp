/// Results of the runs behind the paper's figures, and values derived from them.
#pragma once

#include "apps/reproduce/element_figures.hpp"
#include "core/analysis/shear_band.hpp"
#include "core/campaign/run_views.hpp"
#include "materials/element/bifurcation.hpp"

namespace riedel {

/// u/h0 of the deformed specimens in the paper [-]
inline constexpr double drawn_strain = 0.05;

class PaperResults {
public:
  /// @param runs of all ways; those of this one are kept
  PaperResults(const std::vector<RunResult>& runs, Figures figures, const Values& paper_case, Way way);

  [[nodiscard]] Runs all() const { return runs_; }
  [[nodiscard]] const Way& way() const { return way_; }
  [[nodiscard]] bool filtered() const { return !way_.suffix.empty(); }
  /// The name of a run in this way.
  [[nodiscard]] std::string in_this_way(const std::string& name) const { return name + way_.suffix; }
  [[nodiscard]] const Figures& figures() const { return figures_; }
  [[nodiscard]] const Values& paper_case() const { return case_; }
  /// A completed run; null if it did not complete or was not requested.
  [[nodiscard]] const RunResult* done(const std::string& name) const;
  [[nodiscard]] std::vector<RunResult> some(const std::vector<std::string>& names) const; ///< those that exist

  /// A figure of a run's summary, or of the band in it as "band.…"; NaN where there is none.
  [[nodiscard]] double figure(const std::string& run, const std::string& name) const;
  /// φ at a strain by the initial width, as in the paper; NaN where there is none [deg]
  [[nodiscard]] double angle_at(const std::string& run, double u_over_h) const;
  /// The same by the present width, for the true stress [deg]
  [[nodiscard]] double true_angle_at(const std::string& run, double u_over_h) const;
  /// ψ at the peak, sin ψ = −(ε̇1 + ε̇3)/(ε̇1 − ε̇3), from the width of the specimen over the last 0.3 % of u/h0 before
  /// it; NaN where there is none [deg]
  [[nodiscard]] double dilatancy_at_peak(const std::string& run) const;
  /// Vertical shortening of the blocks on both sides of the band at a strain, from a plane through the displacements
  /// of each; NaN where there is no band [-]
  [[nodiscard]] double block_compression(const std::string& run, double u_over_h) const;
  /// The largest difference of two curves between two strains; NaN where one is missing [deg]
  [[nodiscard]] double distance(const std::string& a, const std::string& b, double from, double to) const;
  /// The band at a strain, measured anew from the frame there.
  [[nodiscard]] std::optional<ShearBand> band_at(const std::string& run, double u_over_h) const;

  /// Share of the dilation at a strain, Σ V (e − e0) over the median, in the upper half of the specimen; NaN where
  /// there is no frame [-]
  [[nodiscard]] double dilation_above(const std::string& run, double u_over_h) const;

  /// φ of the one-dimensional band of the same inclination, at the same strain and at the same slip, where the blocks'
  /// share is subtracted from the shortening. NaN where there is no band [deg]
  [[nodiscard]] double band_angle(const std::string& run, double u_over_h) const;
  [[nodiscard]] double band_angle_at_equal_slip(const std::string& run, double u_over_h) const;

  /// The homogeneous test of the paper's sand at an initial void ratio, to the end of the paper's case.
  [[nodiscard]] const HomogeneousTest& homogeneous(double void_ratio) const;

private:
  std::vector<RunResult> runs_;
  Figures figures_;
  Values case_;
  Way way_;
  mutable std::map<double, HomogeneousTest> homogeneous_; ///< made when first asked for
};

/// Void ratio of points inside the band and outside of it, as in Figure 9.
struct PointCurve {
  std::string name;                         ///< "1" to "3" outside, "4" to "6" inside
  double x = 0, y = 0;                      ///< where the point started [m]
  std::vector<double> u_over_h, void_ratio; ///< [-]
  double pressure = 0;                      ///< p of the last frame [Pa]
};
/// Three columns of the specimen: the point that is loosest at the end, and one 20 mm from the platen that the band
/// does not reach. Empty where the run has no frames.
std::vector<PointCurve> points_in_and_out(const RunResult& run, const Values& paper_case);

} // namespace riedel
