/// A case of the biaxial test: what its keys say, read once.
#pragma once

#include "core/base/parameters.hpp"
#include "core/base/types.hpp"

#include <array>

namespace riedel {

/// Names and meanings are those of the keys in docs/input.md. Lengths in m, stresses in Pa, times in s.
struct BiaxialCase {
  struct Specimen {
    double width, height, void_ratio;
    std::int64_t points_per_cell; ///< along each axis
    double rotation;              ///< [deg]
    std::int64_t depth_cells;
  };
  struct Imperfection {
    double void_ratio;
    std::array<double, 2> size, centre; ///< centre as shares of width and height [-]
    double factor;                      ///< of the strength [-]
    double deviation, correlation_length;
    std::int64_t seed;
  };
  struct Grid {
    std::array<std::int64_t, 2> cells;
    int dimensions;
  };
  enum class Platen { moving_grid, rigid_points };
  enum class Lateral { virtual_stress, points };
  struct Loading {
    double speed, ramp_time, final_strain, confining_pressure, gravity;
    Platen platen;
    Lateral lateral;
  };
  struct Law {
    std::string model;
    Values parameters; ///< by their names without the section
  };
  struct Nonlocal {
    double length; ///< l_c; 0: local
    std::string variable, search, averager;
  };
  struct Output {
    double every_strain, frames_every_strain; ///< [-]
    bool vtk, plots;
    double band_void_ratio; ///< [-]
  };

  explicit BiaxialCase(const Values& values);

  std::string scheme;
  Values interpolation; ///< the scheme's options, by their names without the section
  Specimen specimen;
  Imperfection imperfection;
  Grid grid;
  Loading loading;
  Law material;
  Nonlocal nonlocal;
  Output output;
  Values keys; ///< all of them, for messages and for code that reads whole sections, such as the step
};

} // namespace riedel
