/// What runs of the biaxial test look like on a page.
#pragma once

#include "apps/campaign/run_result.hpp"
#include "apps/drawn_fields.hpp"
#include "apps/report/page.hpp"
#include "core/io/frame.hpp"

#include <optional>
#include <span>

namespace riedel {

using Runs = std::span<const RunResult>;

/// "%.{digits}f"
std::string with_digits(double x, int digits);

/// φ over u/h0 of all runs that have a history; their names are the ids.
/// @param column of the history: by the initial width, or phi_true_deg by the present one
Plot curves_of(Runs runs, const std::string& title, const std::string& column = "phi_mob_deg");

/// Peak, residual angle, and the band at the end.
PageTable band_table(Runs runs);
/// Energies, mass, steps and time.
PageTable cost_table(Runs runs);
/// What the runs differ in; those that are not done with the reason.
PageTable settings_table(Runs runs);

/// A value of the history at a strain, by straight lines between rows; none outside of it.
std::optional<double> history_at(const RunResult& run, const std::string& column, double u_over_h);
/// The frame nearest to a strain that the run has reached, in three dimensions its mean over the depth; none where no
/// frames were written, or none of which that mean could be taken.
std::optional<Frame> frame_at(const RunResult& run, double u_over_h);
/// The same; none, and a warning, where it is damaged.
std::optional<Frame> readable_frame(const RunResult& run, double u_over_h);
/// The strain that every run with frames has reached.
double common_strain(Runs runs);

/// One range for a field of several frames, without the most extreme 0.2 % of the points.
Interval field_range(std::span<const Frame> frames, const DrawnField& field);
/// A field of all runs that have frames, in colours of that range.
PagePictures field_pictures(Runs runs, const DrawnField& field, double u_over_h);

} // namespace riedel
