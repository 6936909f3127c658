/// history.csv: a header, then one row per output, readable during the run.
#pragma once

#include "core/io/atomic_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace riedel {

class History {
public:
  /// Creates the file with its header. @throws RunError with path and reason
  History(std::filesystem::path path, const std::vector<std::string>& columns);

  /// One number per column, printed so that it reads back identically to the bit. @throws RunError
  void add(std::span<const double> row);

private:
  OutputFile file_;
  std::size_t columns_;
};

} // namespace riedel
