#include "apps/element/incremental/variables.hpp"

#include <numbers>

namespace riedel {

namespace {

const double root_2 = std::numbers::sqrt2, root_3 = std::numbers::sqrt3;
constexpr IncrementalPair shear_12{"ln_12", "tau", 1, 1}, shear_13{"ln_13", "tau_13", 1, 1},
    shear_23{"ln_23", "tau_23", 1, 1};

constexpr std::array<IncrementalShorthand, 9> shorthands{{
    {"*oedometrice1", 0, {}, "*cartesian"},
    {"*oedometrics1", 0, {true}, "*cartesian"},
    {"*triaxiale1", 0, {false, true, true}, "*cartesian"},
    {"*triaxials1", 0, {true, true, true}, "*cartesian"},
    {"*triaxialueq", 1, {}, "*roscoe"},
    {"*triaxialuq", 1, {false, true}, "*roscoe"},
    {"*purerelaxation", -1, {}, "*cartesian"},
    {"*purecreep", -1, {true, true, true, true, true, true}, "*cartesian"},
    {"*undrainedcreep", -1, {false, true, true, true, true, true}, "*roscoe"},
}};

} // namespace

/// Those of Roscoe and Rendulic count compression positive; the isomorphic ones are
/// normalised, so that stress and strain are rotated alike.
const std::map<std::string, IncrementalVariables>& incremental_variables() {
  static const std::map<std::string, IncrementalVariables> all{
      {"*cartesian",
       {{{"ln_1", "sigma_1", -1, -1},
         {"ln_2", "sigma_2", -1, -1},
         {"ln_3", "sigma_3", -1, -1},
         shear_12,
         shear_13,
         shear_23}}},
      {"*roscoe",
       {{{"ln_p", "p", 1, 1}, {"ln_q", "q", 1, 1}, {"ln_z", "sigma_2_minus_3", 1, 1}, shear_12, shear_13, shear_23}}},
      {"*roscoeisomorph",
       {{{"ln_p", "p", root_3, 1 / root_3},
         {"ln_q", "q", root_2 / root_3, root_3 / root_2},
         {"ln_z", "sigma_2_minus_3", 1 / root_2, root_2},
         shear_12,
         shear_13,
         shear_23}}},
      {"*rendulic",
       {{{"ln_1", "sigma_1", 1, 1},
         {"ln_2_plus_3", "sigma_2_plus_3", root_2, root_2},
         {"ln_z", "sigma_2_minus_3", 1 / root_2, root_2},
         shear_12,
         shear_13,
         shear_23}}}};
  return all;
}

std::span<const IncrementalShorthand> incremental_shorthands() { return shorthands; }

} // namespace riedel
