#include "apps/reproduce/statements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riedel {

namespace {

/// For one way: where, claim, verdict, measured, theory, reason; for several, verdict and measured for each.
std::vector<std::string> columns_of(const std::vector<Verdicts>& verdicts) {
  std::vector<std::string> columns{"where", "the paper says"};
  for (const Verdicts& one : verdicts) {
    columns.push_back(verdicts.size() == 1 ? "verdict" : one.way);
    columns.emplace_back("measured");
  }
  columns.emplace_back("theory");
  columns.emplace_back("reason");
  return columns;
}

/// The texts of several ways, without repetitions.
std::string joined(const std::vector<Verdicts>& verdicts, std::size_t i, std::string Statement::*part) {
  std::vector<std::string> texts;
  for (const Verdicts& one : verdicts)
    if (const std::string& text = one.statements[i].*part;
        !text.empty() && std::ranges::find(texts, text) == texts.end())
      texts.push_back(text);
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : " / ") + text;
  return all;
}

std::vector<std::string> cells_of(const std::vector<Verdicts>& verdicts, std::size_t i) {
  std::vector<std::string> cells{verdicts.front().statements[i].where, verdicts.front().statements[i].claim};
  for (const Verdicts& one : verdicts) {
    cells.emplace_back(name_of(one.statements[i].verdict));
    cells.push_back(one.statements[i].measured);
  }
  cells.push_back(joined(verdicts, i, &Statement::theory));
  cells.push_back(joined(verdicts, i, &Statement::reason));
  return cells;
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
           .measured = "triaxial, 500 kPa, ε₁ = 70 %, three e₀: φ " + fixed_text(low, 2) + " to " +
                       fixed_text(high, 2) + "°, e " + fixed_text(dense, 3) + " to " + fixed_text(loose, 3) +
                       " (±0.5°, ±0.01)",
           .theory = "φ_c = 30°, e_c = " + fixed_text(end.expected_void_ratio, 3),
           .verdict = holds ? Verdict::agrees : Verdict::differs,
           .reason = ""}};
}

PageTable statement_table(const std::vector<Verdicts>& verdicts) {
  const std::vector<std::string> columns = columns_of(verdicts);
  PageTable table{
      .caption = "Each statement of the paper's text beside what was measured; in brackets the tolerance that decides.",
      .header = columns,
      .rows = {},
      .text_columns = columns.size(),
      .long_text = true};
  for (std::size_t i = 0; i < verdicts.front().statements.size(); ++i) {
    PageRow row;
    for (const std::string& cell : cells_of(verdicts, i)) row.cells.push_back({cell});
    for (std::size_t way = 0; way < verdicts.size(); ++way)
      row.cells[2 + 2 * way].look = look_of(verdicts[way].statements[i].verdict);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string statement_markdown(const std::vector<Verdicts>& verdicts) {
  std::string text, rule;
  for (const std::string& column : columns_of(verdicts)) text += "| " + column + " ", rule += "|---";
  text += "|\n" + rule + "|\n";
  for (std::size_t i = 0; i < verdicts.front().statements.size(); ++i) {
    for (const std::string& cell : cells_of(verdicts, i)) text += "| " + in_markdown(cell) + " ";
    text += "|\n";
  }
  return text;
}

std::string statement_text(const std::vector<Verdicts>& verdicts) {
  const std::string indent(13, ' ');
  std::string text;
  for (std::size_t i = 0; i < verdicts.front().statements.size(); ++i) {
    const Statement& first = verdicts.front().statements[i];
    text += first.where + ": " + first.claim + "\n";
    for (const Verdicts& one : verdicts) {
      const Statement& s = one.statements[i];
      const std::string verdict = name_of(s.verdict);
      text += "  " + verdict + std::string(indent.size() - 2 - verdict.size(), ' ') + s.measured +
              (verdicts.size() > 1 ? ", " + one.way : "") + "\n";
    }
    for (const auto& [before, part] : {std::pair{"theory: ", &Statement::theory}, {"", &Statement::reason}})
      if (const std::string all = joined(verdicts, i, part); !all.empty()) text += indent + before + all + "\n";
  }
  return text;
}

} // namespace riedel
