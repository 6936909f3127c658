/// A case of an element test: what its keys say, read once.
#pragma once

#include "apps/element/tests/test.hpp"

namespace riedel {

/// Names and meanings are those of the keys in docs/input.md. Lengths in m, stresses in Pa, times in s.
struct ElementCase {
  struct Driver {
    std::string kind;
    double tolerance; ///< [-]
  };
  struct Law {
    std::string model;
    Values parameters; ///< by their names without the section
  };
  struct Loading {
    double pressure = 0.0;             ///< from all sides at the start; the test has its own name for it
    double final_strain = 0.0;         ///< [-]
    std::optional<double> limit = {};  ///< ends the test early, in the unit of the limited measure
    double rate = 0.0;                 ///< at one point [1/s]
    double speed = 0.0, ramp_time = 0; ///< of the driven plate
  };
  /// For the driver mpm.
  struct Specimen {
    double size = 0.0;
    std::int64_t cells = 1, points_per_cell = 1; ///< along each edge
    int dimensions = 2;
    bool free_interior = false;
  };
  struct Initial {
    Sym<double> total_stress = {}; ///< tension positive
    double pore_pressure = 0.0, water_bulk_modulus = 0.0;
    std::array<double, 3> intergranular_strain{}; ///< compression positive [-]
  };

  /// @param values of all `element_keys`
  explicit ElementCase(const Values& values);

  std::string test;
  const ElementTest* named; ///< the named test; null for a path
  double void_ratio;
  Law material;
  Driver driver;
  Loading loading;           ///< of a named test
  Specimen specimen;         ///< of a named test
  std::string scheme;        ///< of a named test
  Values interpolation = {}; ///< the scheme's options, by their names without the section
  Initial initial;           ///< of a path
  double every_strain;
  bool plots;
  Values keys; ///< all of them, for messages and for code that reads whole sections, such as the step and the stages
};

} // namespace riedel
