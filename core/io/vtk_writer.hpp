/// A run as a time series for ParaView: the points, and their domains as cells.
#pragma once

#include "core/io/frame.hpp"

#include <filesystem>
#include <vector>

namespace riedel {

/// Writes into its directory
///
///     points.pvd     points/points_000000.vtp ...      points with every field
///     domains.pvd    domains/domains_000000.vtp ...    domains (.vtu in 3-D) with the same fields as cell data
///
/// Each file is compressed and appears complete; the two .pvd files list what has been written so far, so that the
/// series can be opened during the run.
class SeriesWriter {
public:
  /// Creates the directories; throws InputError if that is impossible.
  explicit SeriesWriter(std::filesystem::path directory);

  /// Adds a frame. Throws RunError with path and reason if a file cannot be written; earlier frames stay readable.
  void write(const Frame& frame);

  [[nodiscard]] std::size_t frames() const { return points_.size(); }

private:
  struct Entry {
    double time;      ///< [s]
    std::string file; ///< relative to the directory
  };
  void write_index(const std::string& name, const std::vector<Entry>& entries) const;

  std::filesystem::path directory_;
  std::vector<Entry> points_, domains_;
};

} // namespace riedel
