/// What a path can prescribe of a point, or watch in it: strains and stresses by the names of element.csv.
#pragma once

#include "materials/element/point_driver.hpp"

namespace riedel {

/// Water in the pores of a specimen that lets none of it out: its pressure rises by K_w times the decrease of volume.
/// It carries no shear; the law's stress is the effective one.
struct PoreWater {
  double bulk_modulus = 0.0, initial_pressure = 0.0; ///< K_w, at the start [Pa]

  [[nodiscard]] bool present() const { return bulk_modulus != 0.0 || initial_pressure != 0.0; }
  [[nodiscard]] double pressure(const MaterialPoint& q) const {
    return initial_pressure - bulk_modulus * trace(q.strain);
  }
};

struct Measure {
  std::string name;
  std::string unit; ///< "Pa" of a stress, "-" of a strain, "deg" of an angle
  std::string doc;
  double (*of)(const MaterialPoint&);
  double pore_share = 0.0;       ///< how often the pressure of the water stands in it, beside the law's stress
  bool can_be_prescribed = true; ///< or only watched

  [[nodiscard]] double at(const MaterialPoint& q, const PoreWater& water) const {
    return pore_share == 0.0 ? of(q) : of(q) + pore_share * water.pressure(q);
  }
};

/// Compression positive, lengths over initial lengths.
const std::vector<Measure>& measures();

/// @throws InputError that lists the known ones
const Measure& find_measure(std::string_view name);

/// That the measure becomes `target` at the end of the leg.
Condition condition(const Measure& measure, const PoreWater& water, double target);

} // namespace riedel
