/// Quantities that a path can prescribe or monitor at a point: strains and stresses by the names of element.csv.
#pragma once

#include "materials/element/point_driver.hpp"

namespace riedel {

/// Pore water of an undrained specimen: its pressure rises by K_w times the decrease of volume. It carries no shear;
/// the law's stress is the effective one.
struct PoreWater {
  double bulk_modulus = 0.0, initial_pressure = 0.0; ///< K_w, at the start [Pa]

  [[nodiscard]] bool present() const { return bulk_modulus != 0.0 || initial_pressure != 0.0; }
  [[nodiscard]] double pressure(const MaterialPoint& q) const {
    return initial_pressure - bulk_modulus * trace(q.strain);
  }
};

struct Measure {
  std::string name;
  std::string unit; ///< "Pa" for a stress, "-" for a strain, "deg" for an angle
  std::string doc;
  double (*of)(const MaterialPoint&);
  double pore_share = 0.0;       ///< factor of the water pressure in it, in addition to the law's stress
  bool can_be_prescribed = true; ///< otherwise only monitored

  [[nodiscard]] double at(const MaterialPoint& q, const PoreWater& water) const {
    return pore_share == 0.0 ? of(q) : of(q) + pore_share * water.pressure(q);
  }
};

/// Compression positive, lengths over initial lengths.
const std::vector<Measure>& measures();

/// @throws InputError that lists the known ones
const Measure& find_measure(std::string_view name);

/// The condition that the measure reaches `target` at the end of the leg.
Condition condition(const Measure& measure, const PoreWater& water, double target);

} // namespace riedel
