/// Representation of runs on a page.
#pragma once

#include "core/campaign/run_result.hpp"
#include "core/draw/drawn_fields.hpp"
#include "core/draw/page.hpp"
#include "core/io/frame.hpp"

#include <optional>
#include <span>

namespace riedel {

/// The curves of all runs that have one; the ids are the runs' names.
Plot curves_of(Runs runs, const std::string& title, const CurveAxes& axes);

/// The settings in which the runs differ; unfinished runs with the reason.
PageTable settings_table(Runs runs);

/// A value of a biaxial history at a strain, interpolated linearly between rows; none outside the range.
std::optional<double> history_at(const RunResult& run, const std::string& column, double u_over_h);
/// The frame nearest to a strain that the run has reached, in three dimensions its mean over the depth; none if no
/// frames were written or no mean can be taken.
std::optional<Frame> frame_at(const RunResult& run, double u_over_h);
/// The same; none, with a warning, if the frame is damaged.
std::optional<Frame> readable_frame(const RunResult& run, double u_over_h);
/// Frames that have a field, each with the label of its run.
struct LabelledFrames {
  std::vector<Frame> frames;
  std::vector<std::string> labels;
};
/// Runs without the field or with damaged frames are left out.
LabelledFrames frames_with(const DrawnField& field, std::span<const RunResult* const> runs, double u_over_h);

/// "mean pressure p [kPa], u/h₀ = 5.0 %", the label of a picture's colours.
std::string field_label(const DrawnField& field, double u_over_h, int digits);

/// The strain that every run with frames has reached.
double common_strain(Runs runs);

/// One range for a field of several frames, excluding the most extreme 0.2 % of the points.
Interval field_range(std::span<const Frame> frames, const DrawnField& field);
/// A field of all runs that have frames, with colours over that range.
PagePictures field_pictures(Runs runs, const DrawnField& field, double u_over_h);

} // namespace riedel
