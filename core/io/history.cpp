#include "core/io/history.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace riedel {

History::History(std::filesystem::path path, const std::vector<std::string>& columns)
    : file_(std::move(path)), columns_(columns.size()) {
  std::string header;
  for (const std::string& column : columns) header += (header.empty() ? "" : ",") + column;
  file_.write(header + "\n");
}

void History::add(std::span<const double> row) {
  if (row.size() != columns_) throw std::logic_error("a row of the history has as many numbers as the header");
  std::string text;
  for (const double x : row) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    if (!text.empty()) text += ',';
    text.append(buffer.data(), end.ptr);
  }
  file_.write(text + "\n"); // one write, so that a reader never sees half a row
}

} // namespace riedel
