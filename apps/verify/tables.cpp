#include "apps/verify/tables.hpp"

#include "apps/built_in.hpp"
#include "apps/command_line.hpp"
#include "core/campaign/legend.hpp"
#include "core/draw/plot.hpp"
#include "core/io/csv_cell.hpp"
#include "core/io/figure_json.hpp"
#include "core/io/markdown_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace riedel {

namespace {

std::string text_of(const char* form, double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), form, x);
  return text.data();
}

std::string order_text(double order) { return std::isfinite(order) ? text_of("%.2f", order) : "–"; }

TableRow head_of(const VerifyProblem& problem) {
  TableRow head{"scheme"};
  for (const Index cells : problem.cells) head.push_back(std::to_string(cells) + " cells");
  head.insert(head.end(), {"order", "expected"});
  head.insert(head.end(), problem.figures.begin(), problem.figures.end());
  head.emplace_back("ns");
  return head;
}

TableRow row_of(const VerifyStudy& study) {
  TableRow row{study.scheme};
  for (std::size_t i = 0; i < study.problem->cells.size(); ++i)
    row.push_back(i < study.runs.size() ? text_of("%.2e", study.runs[i].error) : study.failure.empty() ? "–" : "fails");
  row.insert(row.end(), {order_text(study.order()), study.expected().text});
  for (std::size_t i = 0; i < study.problem->figures.size(); ++i)
    row.push_back(study.runs.empty() ? "–" : text_of("%+.1e", study.runs.back().figures[i]));
  row.push_back(study.runs.empty() ? "–" : figure(study.runs.back().ns));
  return row;
}

/// As in "frequency=-3.4e-04 energy=-3.0e-05".
std::string figures_text(const VerifyProblem& problem, const VerifyRun& run) {
  std::string text;
  for (std::size_t i = 0; i < problem.figures.size(); ++i)
    text += (i == 0 ? "" : " ") + problem.figures[i] + "=" + text_of("%.4e", run.figures[i]);
  return text;
}

std::string number_cell(const char* form, double x) { return std::isfinite(x) ? text_of(form, x) : ""; }

} // namespace

std::string verify_tables(const std::vector<VerifyStudy>& studies) {
  std::string text;
  for (auto first = studies.begin(); first != studies.end();) {
    const VerifyProblem& problem = *first->problem;
    const std::string points = first->points > 0 ? ", points per cell and axis: " + std::to_string(first->points) : "";
    std::vector<TableRow> rows;
    std::string failures;
    for (; first != studies.end() && first->problem == &problem; ++first) {
      rows.push_back(row_of(*first));
      if (!first->failure.empty()) failures += "\n" + first->scheme + ": " + first->failure + "\n";
    }
    text += (text.empty() ? "" : "\n") +
            ("**" + problem.name + "**: " + problem.title + points + ". " + problem.measure + " (" + problem.source +
             ").\n\n") +
            markdown_table(head_of(problem), rows, 1) + failures;
  }
  return text;
}

std::string verify_csv(const std::vector<VerifyStudy>& studies) {
  std::string text = "problem,scheme,cells,error,order,expected_order,ns_per_point_step,failure,figures\n";
  for (const VerifyStudy& study : studies) {
    const auto line = [&](std::size_t i, const std::string& numbers, const std::string& ns, const std::string& end) {
      text += study.problem->name + "," + csv_cell(study.scheme) + "," + std::to_string(study.problem->cells[i]) + "," +
              numbers + "," + study.expected().text + "," + ns + "," + end + "\n";
    };
    for (std::size_t i = 0; i < study.runs.size(); ++i)
      line(i, exact_text(study.runs[i].error) + "," + number_cell("%.4f", study.order()),
           text_of("%.4g", study.runs[i].ns), "," + figures_text(*study.problem, study.runs[i]));
    if (!study.failure.empty()) line(study.runs.size(), ",", "", csv_cell(study.failure) + ",");
  }
  return text;
}

nlohmann::ordered_json verify_summary(const std::vector<VerifyStudy>& studies, const std::string& status) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const VerifyStudy& study : studies) {
    nlohmann::ordered_json errors = nlohmann::ordered_json::array(), cells = errors;
    for (std::size_t i = 0; i < study.runs.size(); ++i) {
      errors.push_back(study.runs[i].error);
      cells.push_back(study.problem->cells[i]);
    }
    all.push_back({{"problem", study.problem->name},
                   {"scheme", study.scheme},
                   {"cells", cells},
                   {"errors", errors},
                   {"order", figure_json(study.order())},
                   {"expected", study.expected().text},
                   {"missed", study.missed()},
                   {"failure", study.failure},
                   {"ns_per_point_step", figure_json(study.runs.empty() ? std::nan("") : study.runs.back().ns)}});
  }
  return {{"case", "verify"}, {"version", version()}, {"status", status}, {"studies", all}};
}

namespace {

/// Errors as a curve, in the colour that the scheme has everywhere.
Series series_of(const VerifyStudy& study) {
  static std::vector<std::string> schemes = full_catalogue().in_2d.schemes.names();
  const std::size_t number = color_of_scheme(schemes, study.scheme);
  Series series{.label = study.scheme, .x = {}, .y = {}};
  if (std::isfinite(study.order())) series.label += ", order " + order_text(study.order());
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    series.x.push_back(static_cast<double>(study.problem->cells[i]));
    series.y.push_back(study.runs[i].error);
  }
  series.color = palette_color(number);
  series.dashes = dash_pattern(number % 2); // coinciding curves both show
  series.marker = marker_of(number);
  return series;
}

/// A straight line of each expected order beneath the curves.
std::vector<Series> slopes(const std::vector<VerifyStudy>& studies, const VerifyProblem& problem) {
  constexpr Color grey{0.6, 0.6, 0.6};
  std::set<int> orders;
  double minimum = std::numeric_limits<double>::infinity();
  for (const VerifyStudy& study : studies) {
    if (study.problem != &problem || study.runs.size() < 2) continue;
    if (study.expected().min_order > 0.0) orders.insert(static_cast<int>(std::ceil(study.expected().min_order)));
    for (const VerifyRun& run : study.runs)
      if (run.error > 0.0) minimum = std::min(minimum, run.error);
  }
  std::vector<Series> lines;
  const double first = static_cast<double>(problem.cells.front()), last = static_cast<double>(problem.cells.back());
  for (const int order : orders) {
    const double end = 0.6 * minimum;
    lines.push_back({.label = "slope of order " + std::to_string(order),
                     .x = {first, last},
                     .y = {end * std::pow(last / first, order), end},
                     .style = lines.empty() ? Style::dashed : Style::dotted,
                     .color = grey});
  }
  return lines;
}

} // namespace

void draw_verify(const std::vector<VerifyStudy>& studies, const VerifyProblem& problem,
                 const std::filesystem::path& folder) {
  const std::string y_label = "error [-]";
  Plot convergence{.title = problem.title, .x_label = "cells", .y_label = y_label, .series = {}};
  convergence.log_x = convergence.log_y = true;
  convergence.x_ticks.assign(problem.cells.begin(), problem.cells.end());
  convergence.x_range =
      Interval{0.9 * static_cast<double>(problem.cells.front()), 1.1 * static_cast<double>(problem.cells.back())};
  Plot cost{.title = problem.title,
            .x_label = "ns per point and step, with the finest cells",
            .y_label = y_label,
            .series = {}};
  double minimum = std::numeric_limits<double>::infinity(), maximum = 0.0; // cost
  for (const VerifyStudy& study : studies) {
    if (study.problem != &problem || study.runs.empty()) continue;
    Series errors = series_of(study), times = errors;
    times.label = study.scheme;
    times.x.assign(errors.x.size(), study.runs.back().ns);
    minimum = std::min(minimum, study.runs.back().ns);
    maximum = std::max(maximum, study.runs.back().ns);
    convergence.series.push_back(std::move(errors));
    cost.series.push_back(std::move(times));
  }
  for (Series& line : slopes(studies, problem)) convergence.series.push_back(std::move(line));
  cost.log_x = maximum > 3.0 * minimum;
  cost.log_y = true;
  if (maximum > 0.0) cost.x_range = Interval{0.95 * minimum, 1.05 * maximum};
  write_png(folder / "convergence.png", convergence);
  write_png(folder / "cost.png", cost);
}

} // namespace riedel
