#include "materials/intergranular_strain.hpp"

namespace riedel {

Keys IntergranularStrainParameters::keys() {
  // Defaults: Hochstetten sand, Niemunis & Herle (1997).
  return {
      {std::string(chosen),
       false,
       "",
       {},
       "extend the law by intergranular strain (small strains, cycles); local only"},
      {"m_R", 5.0, "-", at_least(1), "stiffness after a reversal of strain by 180°, relative"},
      {"m_T", 2.0, "-", at_least(1), "stiffness after a turn of strain by 90°, relative; at most m_R"},
      {"R", 1e-4, "-", more_than(0), "radius of the elastic range in strain"},
      {"beta_R", 0.5, "-", more_than(0), "exponent of the evolution of intergranular strain β_R"},
      {"chi", 6.0, "-", more_than(0), "exponent of the stiffness in intergranular strain χ"},
  };
}

IntergranularStrainParameters::IntergranularStrainParameters(const Values& given, std::string_view law)
    : m_R(given.number("m_R")),
      m_T(given.number("m_T")),
      R(given.number("R")),
      beta_R(given.number("beta_R")),
      chi(given.number("chi")) {
  check_bounds(keys(), given, law);
  if (m_T > m_R)
    throw InputError(std::string(law) + ": m_T = " + exact_text(m_T) +
                     " is out of range; allowed: [1, m_R = " + exact_text(m_R) + "]");
}

} // namespace riedel
