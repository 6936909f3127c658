/// The fields of a specimen that pictures and reports show.
#pragma once

#include <array>

namespace riedel {

struct DrawnField {
  const char* name;  ///< in a frame; also the name of the picture's file
  const char* label; ///< of the colour bar, with the unit
  double unit;       ///< factor for the frame's numbers
  int component;
};

/// One line per picture. Fields that a frame does not have are left out.
inline constexpr std::array drawn_fields{
    DrawnField{"void_ratio", "void ratio e [-]", 1.0, 0},
    DrawnField{"shear_strain", "shear strain γ [-]", 1.0, 0},
    DrawnField{"mean_pressure", "mean pressure p [kPa]", 1e-3, 0}, // reveals what the void ratio does not show
    DrawnField{"rate_norm", "norm of the strain rate ‖D‖ [1/s]", 1.0, 0},
};

/// Fields shown of several runs in PNG files: void ratio, and what it does not show.
inline constexpr std::array pictured_fields{drawn_fields[0], drawn_fields[2], drawn_fields[3]};

} // namespace riedel
