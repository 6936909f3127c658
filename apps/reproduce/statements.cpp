#include "apps/reproduce/statements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riedel {

namespace {

const std::vector<std::string> columns{"where", "the paper says", "verdict", "measured", "theory", "reason"};

std::vector<std::string> cells_of(const Statement& s) {
  return {s.where, s.claim, name_of(s.verdict), s.measured, s.theory, s.reason};
}

std::string look_of(Verdict verdict) {
  constexpr std::array looks{"agrees", "differs", "cannot", "faint"};
  return looks[static_cast<std::size_t>(verdict)];
}

/// A bar would end the cell.
std::string in_markdown(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

} // namespace

const char* name_of(Verdict verdict) {
  constexpr std::array names{"agrees", "differs", "cannot hold", "open"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<Statement> element_statements(const CriticalState& end) {
  const auto [low, high] = std::ranges::minmax(end.angle);
  const auto [dense, loose] = std::ranges::minmax(end.void_ratio);
  const bool holds =
      low > 29.5 && high < 30.5 && dense > end.expected_void_ratio - 0.01 && loose < end.expected_void_ratio + 0.01;
  return {{.where = "Figs. 2–5, conclusions",
           .claim = "the material always comes to an asymptotic, critical state",
           .measured = "triaxial, 500 kPa, ε₁ = 70 %, three e₀: φ " + with_digits(low, 2) + " to " +
                       with_digits(high, 2) + "°, e " + with_digits(dense, 3) + " to " + with_digits(loose, 3) +
                       " (±0.5°, ±0.01)",
           .theory = "φ_c = 30°, e_c = " + with_digits(end.expected_void_ratio, 3),
           .verdict = holds ? Verdict::agrees : Verdict::differs,
           .reason = ""}};
}

PageTable statement_table(const std::vector<Statement>& statements) {
  PageTable table{
      .caption = "Each statement of the paper's text beside what was measured; in brackets the tolerance that decides.",
      .header = columns,
      .rows = {},
      .text_columns = columns.size(),
      .long_text = true};
  for (const Statement& statement : statements) {
    PageRow row;
    for (const std::string& cell : cells_of(statement)) row.cells.push_back({cell});
    row.cells[2].look = look_of(statement.verdict);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string statement_markdown(const std::vector<Statement>& statements) {
  std::string text, rule;
  for (const std::string& column : columns) text += "| " + column + " ", rule += "|---";
  text += "|\n" + rule + "|\n";
  for (const Statement& statement : statements) {
    for (const std::string& cell : cells_of(statement)) text += "| " + in_markdown(cell) + " ";
    text += "|\n";
  }
  return text;
}

} // namespace riedel
