#include "materials/element/measures.hpp"

#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "materials/element/curve.hpp"

#include <Eigen/LU>

namespace riedel {

namespace {

template <int Axis>
double strain(const MaterialPoint& q) {
  return 1.0 - q.F(Axis, Axis);
}
template <int Row, int Column>
double shear(const MaterialPoint& q) {
  return q.F(Row, Column);
}
template <int Component>
double stress(const MaterialPoint& q) {
  return Component < 3 ? -q.stress.m[Component] : q.stress.m[Component] / std::numbers::sqrt2;
}
/// ∫ D dt, compression positive; for a shear 2 ∫ D_ij dt.
template <int Component>
double natural(const MaterialPoint& q) {
  return Component < 3 ? -q.strain.m[Component] : q.strain.m[Component] * std::numbers::sqrt2;
}
double natural_volume(const MaterialPoint& q) { return -trace(q.strain); }
double natural_deviator(const MaterialPoint& q) {
  return 2.0 / 3.0 * (natural<0>(q) - 0.5 * (natural<1>(q) + natural<2>(q)));
}
double natural_difference(const MaterialPoint& q) { return 0.5 * (natural<1>(q) - natural<2>(q)); }
double volume_strain(const MaterialPoint& q) { return 1.0 - q.F.determinant(); }
double nothing(const MaterialPoint&) { return 0.0; }
double sum(const MaterialPoint& q) { return stress<1>(q) + stress<2>(q); }
double natural_sum(const MaterialPoint& q) { return natural<1>(q) + natural<2>(q); }
double pressure(const MaterialPoint& q) { return -trace(q.stress) / 3.0; }
double deviator_1(const MaterialPoint& q) { return stress<0>(q) - 0.5 * (stress<1>(q) + stress<2>(q)); }
double difference(const MaterialPoint& q) { return stress<1>(q) - stress<2>(q); }
double mobilised_angle(const MaterialPoint& q) { return principal_angle(q.stress); }

} // namespace

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"eps_1", "-", "strain along 1, change of length over initial length, compression positive", strain<0>},
      {"eps_2", "-", "strain along 2", strain<1>},
      {"eps_3", "-", "strain along 3", strain<2>},
      {"eps_v", "-", "decrease of volume over initial volume; hold: undrained", volume_strain},
      {"gamma", "-", "simple shear u/h0 of planes normal to 2 along 1", shear<0, 1>},
      {"gamma_13", "-", "simple shear of planes normal to 3 along 1", shear<0, 2>},
      {"gamma_23", "-", "simple shear of planes normal to 3 along 2", shear<1, 2>},
      {"sigma_1", "Pa", "stress along 1, compression positive; includes the pore water pressure", stress<0>, 1.0},
      {"sigma_2", "Pa", "stress along 2", stress<1>, 1.0},
      {"sigma_3", "Pa", "stress along 3", stress<2>, 1.0},
      {"tau", "Pa", "shear stress on planes normal to 2 along 1", stress<3>},
      {"tau_13", "Pa", "shear stress on planes normal to 3 along 1", stress<4>},
      {"tau_23", "Pa", "shear stress on planes normal to 3 along 2", stress<5>},
      {"p", "Pa", "mean pressure (sigma_1 + sigma_2 + sigma_3)/3", pressure, 1.0},
      {"q", "Pa", "sigma_1 - (sigma_2 + sigma_3)/2", deviator_1},
      {"sigma_2_minus_3", "Pa", "sigma_2 - sigma_3; 0: the same pressure from all sides", difference},
      {"sigma_2_plus_3", "Pa", "sigma_2 + sigma_3", sum, 2.0},
      {"ln_1", "-", "natural strain along 1, the integral of its rate, compression positive", natural<0>},
      {"ln_2", "-", "natural strain along 2", natural<1>},
      {"ln_3", "-", "natural strain along 3", natural<2>},
      {"ln_12", "-", "natural shear, the integral of 2 D_12", natural<3>},
      {"ln_13", "-", "natural shear, the integral of 2 D_13", natural<4>},
      {"ln_23", "-", "natural shear, the integral of 2 D_23", natural<5>},
      {"ln_p", "-", "natural decrease of volume, conjugate to p", natural_volume},
      {"ln_q", "-", "2/3 (ln_1 - (ln_2 + ln_3)/2), conjugate to q", natural_deviator},
      {"ln_z", "-", "(ln_2 - ln_3)/2, conjugate to sigma_2_minus_3", natural_difference},
      {"ln_2_plus_3", "-", "ln_2 + ln_3", natural_sum},
      {"phi_mob", "deg", "mobilised friction angle", mobilised_angle, 0.0, false},
      {"u", "Pa", "pore water pressure", nothing, 1.0, false},
      {"p_eff", "Pa", "effective mean pressure, p - u", pressure, 0.0, false},
  };
  return all;
}

const Measure& find_measure(std::string_view name) {
  std::vector<std::string> names;
  for (const Measure& measure : measures()) {
    if (measure.name == name) return measure;
    names.push_back(measure.name);
  }
  std::string known;
  for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
  throw InputError("unknown measure '" + std::string(name) + "'" + did_you_mean(name, names) + "; known: " + known);
}

Condition condition(const Measure& measure, const PoreWater& water, double target) {
  const auto value = [&measure, water](const MaterialPoint& q) { return measure.at(q, water); };
  return {.name = measure.name, .measure = value, .target = target, .of_stress = measure.unit == "Pa"};
}

} // namespace riedel
