/// An output in the columns of IncrementalDriver.
#pragma once

#include "core/base/parameters.hpp"
#include "core/io/atomic_file.hpp"
#include "materials/element/measures.hpp"

#include <filesystem>

namespace riedel {

/// The columns time(1) time(2) stran(1..6) stress(1..6) statev(1..), tension positive, stresses in kPa and with the
/// pressure of pore water. The state is that of UMATs for hypoplastic sand: intergranular strain (0 for a law without
/// it), void ratio, with water its pressure, then all other variables; for a UMAT, its own state.
class IncrementalOutput {
public:
  /// @param material the keys of [material]
  IncrementalOutput(const std::filesystem::path& path, const Material& law, const PoreWater& water,
                    const Values& material);
  void add(const MaterialPoint& point);

private:
  struct Column {
    int state;           ///< of the law; −1: it has none, −2: pressure of the water
    double factor = 1.0; ///< from the law's number to that of the file
  };
  void list_of_umat(const Material& law, const Values& material);
  void list_of_sand(const Material& law);

  OutputFile file_;
  PoreWater water_;
  double stress_unit_ = 1e3; ///< [Pa]
  std::vector<Column> columns_;
};

} // namespace riedel
