#include "materials/drucker_prager.hpp"

namespace riedel {

Keys DruckerPrager::parameters() {
  Keys keys = ElastoplasticControl::keys();
  const Keys strength = FrictionalStrength::keys();
  keys.insert(keys.end(), strength.begin(), strength.end());
  keys.push_back({"cone",
                  "compression",
                  "",
                  {},
                  "where the cone meets the Mohr-Coulomb surface: triaxial compression, triaxial extension, or flow "
                  "in plane strain",
                  {"compression", "extension", "plane_strain"}});
  return keys;
}

DruckerPrager::DruckerPrager(const Values& given)
    : ElastoplasticLaw(ElastoplasticControl(given)),
      strength_(given, name),
      cone_(given.text("cone") == "compression" ? Cone::compression
            : given.text("cone") == "extension" ? Cone::extension
                                                : Cone::plane_strain) {
  check_bounds(parameters(), given, name);
}

Vec<3> DruckerPrager::returned(const Vec<3>& trial, const Strength<double>& s) const {
  const double p = trial.mean(), T = strength_.tension_cutoff();
  const Vec<3> deviator = trial - p * Vec<3>::Ones();
  const double root_J2 = std::sqrt(0.5) * deviator.norm();
  const auto stress = [&](double mean, double shear) -> Vec<3> {
    return mean * Vec<3>::Ones() + (root_J2 > 0.0 ? shear / root_J2 : 0.0) * deviator;
  };
  double mean = p, shear = root_J2;
  if (const double f = root_J2 + s.eta * p - s.cohesive; f > 0.0) {
    const double flow = f / (solid().mu + solid().bulk() * s.eta * s.eta_bar); // (7)
    shear = root_J2 - solid().mu * flow;
    mean = p - solid().bulk() * s.eta_bar * flow;
    if (shear < 0.0) shear = 0.0, mean = s.cohesive / s.eta; // (8)
  }
  if (mean <= T) return stress(mean, shear);
  return stress(T, std::max(0.0, std::min(root_J2, s.cohesive - s.eta * T))); // (9), (10)
}

} // namespace riedel
