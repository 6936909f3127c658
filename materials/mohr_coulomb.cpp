#include "materials/mohr_coulomb.hpp"

namespace riedel {

Keys MohrCoulomb::parameters() {
  Keys keys = ElastoplasticControl::keys();
  const Keys strength = FrictionalStrength::keys();
  keys.insert(keys.end(), strength.begin(), strength.end());
  return keys;
}

MohrCoulomb::MohrCoulomb(const Values& given) : ElastoplasticLaw(ElastoplasticControl(given)), strength_(given, name) {
  check_bounds(parameters(), given, name);
}

/// Stress released by a unit of flow on the face of two principal stresses, C r.
Vec<3> MohrCoulomb::flow(int maximum, int minimum, const Strength<double>& s) const {
  Vec<3> relaxed = Vec<3>::Constant(solid().lambda * s.sin_psi);
  relaxed[maximum] += solid().mu * (1.0 + s.sin_psi);
  relaxed[minimum] -= solid().mu * (1.0 - s.sin_psi);
  return relaxed; // (4)
}

/// Return to the nearest of face, edges and apex according to the flow rule; the cut-off is not considered here.
Vec<3> MohrCoulomb::returned_in_shear(const Vec<3>& trial, const Strength<double>& s) const {
  const double f = shear(trial[0], trial[2], s);
  if (f <= 0.0) return trial;
  const double both = s.sin_phi * s.sin_psi;
  const double a = solid().lambda * both + solid().mu * (1.0 + both); // (5)
  const Vec<3> face = trial - f / a * flow(0, 2, s);                  // (6)
  if (face[0] >= face[1] && face[1] >= face[2]) return face;
  if (face[1] > face[0]) {
    const double b = solid().lambda * both + 0.5 * solid().mu * (1.0 - s.sin_phi) * (1.0 - s.sin_psi); // (8)
    const Vec<3> edge = returned_to_edge(trial, s, 0, a, b);
    if (edge[1] >= edge[2]) return edge;
  }
  if (face[2] > face[1]) {
    const double b = solid().lambda * both + 0.5 * solid().mu * (1.0 + s.sin_phi) * (1.0 + s.sin_psi); // (8)
    const Vec<3> edge = returned_to_edge(trial, s, 2, a, b);
    if (edge[0] >= edge[1]) return edge;
  }
  return Vec<3>::Constant(s.cohesive / s.sin_phi); // (9)
}

/// Return to the edge where σ_2 has become equal to the principal stress `twin`.
/// @param a, b decrease of a face's own yield function and of the other face's per unit of flow on it
Vec<3> MohrCoulomb::returned_to_edge(const Vec<3>& trial, const Strength<double>& s, int twin, double a,
                                     double b) const {
  const bool least_is_shared = twin == 0;
  const double f_1 = shear(trial[0], trial[2], s);
  const double f_2 = least_is_shared ? shear(trial[1], trial[2], s) : shear(trial[0], trial[1], s);
  const double per = 1.0 / ((a - b) * (a + b));
  Vec<3> edge = trial - per * (a * f_1 - b * f_2) * flow(0, 2, s) -
                per * (a * f_2 - b * f_1) * (least_is_shared ? flow(1, 2, s) : flow(0, 1, s)); // (7)
  edge[1] = edge[twin] = 0.5 * (edge[1] + edge[twin]);                                         // removes round-off
  return edge;
}

/// Associated flow: each principal stress above the cut-off is reduced to it.
Vec<3> MohrCoulomb::returned_in_tension(const Vec<3>& trial) const {
  const double T = strength_.tension_cutoff(), lambda = solid().lambda;
  Vec<3> sigma = trial;
  double lost = (trial[0] - T) / solid().longitudinal(); // Σ of the multipliers of (10)
  sigma[0] = T;
  sigma[1] = trial[1] - lambda * lost;
  sigma[2] = trial[2] - lambda * lost;
  if (sigma[1] <= T) return sigma;
  lost = (trial[0] + trial[1] - 2.0 * T) / (2.0 * (lambda + solid().mu));
  return {T, T, std::min(T, trial[2] - lambda * lost)};
}

/// At the intersection of face and cut-off: σ_1 and σ_3 are given, and σ_2 stays between them.
Vec<3> MohrCoulomb::returned_to_both(const Vec<3>& trial, const Strength<double>& s) const {
  const double T = strength_.tension_cutoff(), lambda = solid().lambda, mu = solid().mu;
  const double minimum = ((1.0 + s.sin_phi) * T - 2.0 * s.cohesive) / (1.0 - s.sin_phi); // (11)
  const double d_1 = trial[0] - T, d_3 = trial[2] - minimum;
  const double sum = (d_1 - d_3) / (2.0 * mu); // of the multipliers
  const double sheared = (lambda * sum - d_3) / ((lambda + mu) * (1.0 - s.sin_psi));
  const double middle = trial[1] - lambda * (sum - sheared + sheared * s.sin_psi); // (12)
  return {T, std::clamp(middle, minimum, T), minimum};
}

Vec<3> MohrCoulomb::returned(const Vec<3>& trial, const Strength<double>& s) const {
  const Vec<3> sheared = returned_in_shear(trial, s);
  if (sheared[0] <= strength_.tension_cutoff()) return sheared;
  const Vec<3> torn = returned_in_tension(trial);
  return shear(torn[0], torn[2], s) <= 0.0 ? torn : returned_to_both(trial, s);
}

} // namespace riedel
