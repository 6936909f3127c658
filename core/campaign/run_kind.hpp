/// What a campaign knows of the runs of one kind of case: their files, and what tables and pictures show of them.
#pragma once

#include "core/case/case_kind.hpp"
#include "core/draw/page.hpp"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace riedel {

struct RunResult;
using Runs = std::span<const RunResult>;

/// Columns of a run's curve, and what they are in a plot.
struct CurveAxes {
  std::string x, x_label; ///< a strain, which tells the progress, too; shown in percent
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
  std::vector<std::string> ascending;    ///< those of them that never fall
  std::vector<std::string> schemes = {}; ///< in the order of their colours
  bool has_frames = false;               ///< fields of its points are written for ParaView
  std::string curves_caption = {};       ///< what the curves show, in one sentence
  /// What tables take for granted of the summary of a run that is done. @throws InputError, nlohmann's exceptions
  void (*check_summary)(const nlohmann::ordered_json& summary) = nullptr;
  CurveAxes (*axes)(const CaseFile& given) = nullptr;
  /// How a run that is done came out, in one line.
  std::string (*outcome)(const nlohmann::ordered_json& summary) = nullptr;
  /// More pictures of curves; none where the runs cannot share them. @param subject behind the title
  std::vector<NamedPlot> (*plots)(Runs runs, const std::string& subject) = nullptr;
  /// Behind the curves in a report: a heading and a table each.
  std::vector<std::pair<std::string, PageTable>> (*tables)(Runs runs) = nullptr;
};

} // namespace riedel
