/// Columns of numbers from a comma-separated file with a header.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace riedel {

struct Table {
  std::vector<std::string> names;                                  ///< in the order of the file
  std::map<std::string, std::vector<double>, std::less<>> columns; ///< all of one length

  [[nodiscard]] bool has(std::string_view name) const { return columns.find(name) != columns.end(); }
  [[nodiscard]] const std::vector<double>& operator[](std::string_view name) const {
    return columns.find(name)->second;
  }
};

/// Lines that are empty or begin with # are skipped. "nan" is a number.
/// @throws InputError with file, line and column (counted from one) of a cell that is no number, missing or extra
Table read_table(const std::filesystem::path& path);

} // namespace riedel
