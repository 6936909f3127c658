#include "core/io/table.hpp"

#include "core/base/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/readable.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace riedel {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // as written by spreadsheets
constexpr std::size_t longest_shown = 80;                    ///< in messages [bytes]

struct Cell {
  std::string text;
  std::size_t column; ///< of its first letter, from one
};

std::vector<Cell> cells_of(const std::string& line) {
  constexpr std::string_view blank = " \t\r\"";
  std::vector<Cell> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    std::string text = line.substr(start, end - start);
    const std::size_t first = text.find_first_not_of(blank);
    text = first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
    cells.push_back({text, start + (first == std::string::npos ? 0 : first) + 1});
    start = end + 1;
  }
  return cells;
}

const char* hint(const std::string& text) {
  return text.find(';') == std::string::npos ? "" : "; use commas between cells and points in numbers";
}

double number_in(const Cell& cell, const std::string& place, const std::string& name) {
  double x = 0.0;
  const char *begin = cell.text.data() + (cell.text.starts_with('+') ? 1 : 0),
             *end = cell.text.data() + cell.text.size();
  const auto [stop, error] = std::from_chars(begin, end, x);
  if (cell.text.empty() || error != std::errc{} || stop != end)
    throw InputError(place + std::to_string(cell.column) + ": '" + readable(cell.text, longest_shown) + "' in column " +
                     readable(name, longest_shown) + " is not a number" + hint(cell.text));
  return x;
}

void add_row(Table& table, const std::vector<Cell>& cells, const std::string& place) {
  if (cells.size() != table.names.size())
    throw InputError(place + std::to_string(cells.back().column) + ": the row has " + std::to_string(cells.size()) +
                     " cells, the header " + std::to_string(table.names.size()));
  for (std::size_t c = 0; c < cells.size(); ++c)
    table.columns[table.names[c]].push_back(number_in(cells[c], place, table.names[c]));
}

void take_header(Table& table, const std::vector<Cell>& cells, const std::string& place) {
  for (const Cell& cell : cells) {
    if (cell.text.empty() || table.has(cell.text))
      throw InputError(place + std::to_string(cell.column) + ": the header " +
                       (cell.text.empty() ? "has a column without a name"
                                          : "names '" + readable(cell.text, longest_shown) + "' twice"));
    table.names.push_back(cell.text);
    table.columns[cell.text];
  }
}

} // namespace

Table read_table(const std::filesystem::path& path) {
  std::istringstream file(read_input_file(path));
  Table table;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    const std::string place = path.string() + ":" + std::to_string(number) + ":";
    if (table.names.empty())
      take_header(table, cells_of(line), place);
    else
      add_row(table, cells_of(line), place);
  }
  if (table.names.empty()) throw InputError(path.string() + ": is empty; the first line names the columns");
  if (table.columns.begin()->second.empty()) throw InputError(path.string() + ": has a header and no row");
  return table;
}

} // namespace riedel
