/// A case that is filled while the files of IncrementalDriver are read.
#pragma once

#include "apps/element/incremental/input_lines.hpp"
#include "core/base/parameters.hpp"
#include "core/case/case_file.hpp"

namespace riedel {

struct IncrementalCase {
  CaseFile given = CaseFile::empty();
  double stress_unit = 1e3; ///< of the files [Pa]

  /// A key, at the place that it was read from. @param value as TOML
  void set(const InputLines& from, const std::string& key, const std::string& value) {
    given.override_with(key + "=" + value, from.place());
  }
  void set(const InputLines& from, const std::string& key, double value) { set(from, key, exact_text(value + 0.0)); }
};

/// Reads test.inp.
void read_incremental_test(IncrementalCase& into, const std::filesystem::path& path);

} // namespace riedel
