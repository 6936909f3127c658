/// What a campaign knows about the runs of one kind of case: their files, and what tables and pictures show of them.
#pragma once

#include "core/case/case_kind.hpp"
#include "core/draw/page.hpp"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace riedel {

struct RunResult;
using Runs = std::span<const RunResult>;

/// Columns of a run's curve, and their role in a plot.
struct CurveAxes {
  std::string x, x_label; ///< a strain, which also gives the progress; shown in percent
  std::string y, y_label;
};

/// A picture and the name of its file.
struct NamedPlot {
  std::string file;
  Plot plot;
};

struct RunKind {
  CaseKind cases;
  std::string curve_file;                ///< in a run's folder, as CSV
  std::vector<std::string> columns;      ///< that this file must have
  std::vector<std::string> ascending;    ///< those of them that never decrease
  std::vector<std::string> schemes = {}; ///< in the order of their colours
  bool has_frames = false;               ///< fields of the points are written for ParaView
  std::string curves_caption = {};       ///< what the curves show, in one sentence
  /// Checks what tables rely on in the summary of a finished run. @throws InputError, nlohmann's exceptions
  void (*check_summary)(const nlohmann::ordered_json& summary) = nullptr;
  CurveAxes (*axes)(const CaseFile& given) = nullptr;
  /// The outcome of a finished run, in one line.
  std::string (*outcome)(const nlohmann::ordered_json& summary) = nullptr;
  /// Further plots of curves; none if the runs cannot share them. @param subject after the title
  std::vector<NamedPlot> (*plots)(Runs runs, const std::string& subject) = nullptr;
  /// Follows the curves in a report: a heading and a table each.
  std::vector<std::pair<std::string, PageTable>> (*tables)(Runs runs) = nullptr;
};

} // namespace riedel
