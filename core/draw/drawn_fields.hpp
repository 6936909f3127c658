/// The fields of a specimen that pictures and reports show.
#pragma once

#include <array>

namespace riedel {

struct DrawnField {
  const char* name;  ///< in a frame; the picture's file is called so, too
  const char* label; ///< of the colours, with the unit
  double unit;       ///< what the frame's numbers are multiplied by
  int component;
};

/// A line for each picture. Fields that a frame does not have are left out.
inline constexpr std::array drawn_fields{
    DrawnField{"void_ratio", "void ratio e [-]", 1.0, 0},
    DrawnField{"shear_strain", "shear strain γ [-]", 1.0, 0},
    DrawnField{"mean_pressure", "mean pressure p [kPa]", 1e-3, 0}, // shows what the void ratio hides
    DrawnField{"rate_norm", "norm of the strain rate ‖D‖ [1/s]", 1.0, 0},
};

/// Those that PNG files show of several runs: void ratio, and what it hides.
inline constexpr std::array pictured_fields{drawn_fields[0], drawn_fields[2], drawn_fields[3]};

} // namespace riedel
