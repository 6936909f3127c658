/// history.csv: a header, then a row per output, readable while the run goes on.
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

  /// One number per column; each is printed so that it reads back to the same bits. @throws RunError
  void add(std::span<const double> row);

private:
  OutputFile file_;
  std::size_t columns_;
};

} // namespace riedel
