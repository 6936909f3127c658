#include "core/campaign/results_table.hpp"

#include "core/io/csv_cell.hpp"

#include <algorithm>

namespace riedel {

namespace {

using nlohmann::ordered_json;
using Row = std::vector<Setting>; ///< column, cell

/// A missing value is an empty cell.
std::string text_of(const ordered_json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The values of a summary; nested ones have the names of both levels.
void flatten(const ordered_json& json, const std::string& prefix, Row& row) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object())
      flatten(value, prefix + key + ".", row);
    else
      row.emplace_back(prefix + key, text_of(value));
  }
}

Row row_of(const RunResult& result) {
  Row row{{"run", result.name}, {"status", name_of(result.status)}, {"reason", result.reason}};
  row.insert(row.end(), result.settings.begin(), result.settings.end());
  Row figures;
  if (result.summary.is_object()) flatten(result.summary, "", figures);
  for (Setting& figure : figures) // a varied scheme already has its column
    if (std::ranges::find(row, figure.first, &Setting::first) == row.end()) row.push_back(std::move(figure));
  return row;
}

std::string outcome_text(const RunKind& kind, const RunResult& result) {
  if (result.status != RunStatus::done) return std::string(name_of(result.status)) + ": " + result.reason;
  return kind.outcome(result.summary);
}

} // namespace

std::string results_csv(const std::vector<RunResult>& results) {
  std::vector<Row> rows;
  std::vector<std::string> columns;
  for (const RunResult& result : results) {
    rows.push_back(row_of(result));
    for (const auto& [column, text] : rows.back())
      if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
  }
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + csv_cell(column);
  text += "\n";
  for (const Row& row : rows) {
    std::string line;
    for (const std::string& column : columns) {
      const auto found = std::ranges::find(row, column, &Setting::first);
      line += (&column == &columns.front() ? "" : ",") + (found == row.end() ? std::string() : csv_cell(found->second));
    }
    text += line + "\n";
  }
  return text;
}

std::string results_text(const RunKind& kind, const std::vector<RunResult>& results) {
  std::size_t widest = 0;
  for (const RunResult& result : results) widest = std::max(widest, result.label.size());
  std::string text;
  for (const RunResult& result : results)
    text += result.label + std::string(widest + 2 - result.label.size(), ' ') + outcome_text(kind, result) + "\n";
  return text;
}

} // namespace riedel
