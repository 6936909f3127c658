#include "core/io/markdown_table.hpp"

#include "core/base/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace riedel {

namespace {

/// Columns on a terminal: a µ or × takes one.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string line(const TableRow& cells, const std::vector<std::size_t>& widths, std::size_t left) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string blank(widths[i] - width(cells[i]), ' ');
    text += " " + (i < left ? cells[i] + blank : blank + cells[i]) + " |";
  }
  return text + "\n";
}

} // namespace

std::string markdown_table(const TableRow& head, const std::vector<TableRow>& rows, std::size_t left) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < head.size(); ++i) {
    widths.push_back(std::max<std::size_t>(width(head[i]), 2));
    for (const TableRow& row : rows) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text = line(head, widths, left) + "|";
  for (std::size_t i = 0; i < head.size(); ++i)
    text += " " + std::string(widths[i] - 1, '-') + (i < left ? "-" : ":") + " |";
  text += "\n";
  for (const TableRow& row : rows) text += line(row, widths, left);
  return text;
}

std::string figure(double x) {
  const int digits = std::abs(x) < 9.995 ? 2 : std::abs(x) < 99.95 ? 1 : 0;
  return fixed_text(x, digits);
}

} // namespace riedel
