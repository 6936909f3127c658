/// Columns of a comma-separated file, by the names in its first row.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace riedel::test {

using Table = std::map<std::string, std::vector<double>>;

inline Table read_csv(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line, cell;
  std::vector<std::string> names;
  std::getline(file, line);
  for (std::stringstream row(line); std::getline(row, cell, ',');) names.push_back(cell);
  Table table;
  while (std::getline(file, line)) {
    std::stringstream row(line);
    for (std::size_t c = 0; std::getline(row, cell, ','); ++c) table[names.at(c)].push_back(std::stod(cell));
  }
  return table;
}

inline Table reference(const std::string& name) {
  return read_csv(std::string(SOURCE_DIR) + "/tests/reference/" + name);
}

/// y at x by linear interpolation; x must rise.
inline double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  std::size_t i = 1;
  while (i + 1 < xs.size() && xs[i] < x) ++i;
  const double t = (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return (1 - t) * ys[i - 1] + t * ys[i];
}

} // namespace riedel::test
