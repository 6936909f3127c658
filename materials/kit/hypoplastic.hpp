/// Common part of hypoplastic laws of sand. Their stress rate is linear in D and in d, L:D + N d, with
///   L = f_s [c_I I + c_ss σ̂⊗σ̂],   N = f_s f_d c_N (σ̂ + σ̂*);
/// a law provides the factors, from which everything else follows: the rate, its bounds, and intergranular strain.
#pragma once

#include "materials/kit/sand.hpp"

namespace riedel {

/// L and N at one stress and void ratio.
template <class Real>
struct HypoplasticParts {
  Sym<Real> s, s_dev; ///< σ̂ = σ/tr σ and its deviator σ̂*
  Real f_s, f_d;      ///< factors of pressure and density [Pa], [-]
  Real c_I, c_ss;     ///< of L
  Real c_N;           ///< of N
  Real e_bar;         ///< the equivalent void ratio at zero pressure
};

/// σ° = f_s [c_I D + c_ss σ̂ (σ̂:D) + f_d c_N (σ̂ + σ̂*) d]   [Pa/s]
template <class Real>
Sym<Real> stress_rate(const HypoplasticParts<Real>& q, const Sym<Real>& D, const std::type_identity_t<Real>& d) {
  const Sym<Real> L = q.c_I * D + q.c_ss * dot(q.s, D) * q.s;
  const Sym<Real> N = q.c_N * (q.s + q.s_dev);
  return q.f_s * (L + q.f_d * d * N);
}

/// ė = (1 + e) tr D: the grains keep their volume [1/s]
template <class Real>
Real void_ratio_rate(const Real& e, const Sym<Real>& D) {
  return (Real(1.0) + e) * trace(D);
}

/// The maximum of σ̂:nn over all directions n, which is the largest principal value.
template <class Real>
Real max_principal(const HypoplasticParts<Real>& q) {
  const Real lode = acos(-cos_3_lode(q.s_dev)) * Real(1.0 / 3.0);
  return Real(1.0 / 3.0) + Real(std::sqrt(2.0 / 3.0)) * norm(q.s_dev) * cos(lode);
}

/// An upper bound of the stiffness in any direction, loading or unloading: unloading along n adds |N:nn| to L. [Pa]
template <class Real>
Real basic_stiffness(const HypoplasticParts<Real>& q) {
  const Real s_nn = max_principal(q);
  return q.f_s * (q.c_I + q.c_ss * s_nn * s_nn + q.f_d * q.c_N * (Real(2.0) * s_nn - Real(1.0 / 3.0)));
}

/// Largest wave speed of a batch whose state begins with the void ratio and ends, after `States` columns, with the
/// separation. Points out of contact count with the stress at which they will regain contact, so that the time step is
/// then valid. @param stiffness of `HypoplasticParts<Pack>`, an upper bound [Pa]
template <std::size_t States, class Law, class Stiffness>
[[gnu::flatten]] MaterialLimits assess_sand(const Law& law, const MaterialBatch& batch, const Stiffness& stiffness) {
  const Sand& sand = law.sand();
  const Sym<double> at_contact = law.seen(law.contact_stress());
  MaterialLimits answer;
  Pack fastest(0.0); // c² ρ_s
  for (Index p = 0; p < batch.size; p += pack_size) {
    const BatchGroup<Pack, States> group(batch, p);
    const auto [sigma, state] = group.points();
    const Pack e = state[0];
    Sym<Pack> seen = law.seen(sigma);
    const Mask touching = -trace(seen) > Pack(0.0) && group.load(group.separation()) <= Pack(0.0);
    for (std::size_t c = 0; c < 6; ++c) seen.m[c] = select(touching, seen.m[c], Pack(at_contact.m[c]));
    const HypoplasticParts<Pack> parts = law.parts(seen, e);
    const Pack c_squared = stiffness(parts) * (Pack(1.0) + e);
    fastest = select(c_squared > fastest, c_squared, fastest); // skips NaN
    const auto outside = lanes(touching && (parts.e_bar < Pack(sand.e_d0) || parts.e_bar > Pack(sand.e_i0)));
    answer.out_of_bounds += std::count(outside.begin(), outside.begin() + group.size(), true);
  }
  answer.wave_speed = std::sqrt(maximum(fastest) / sand.grain_density);
  return answer;
}

} // namespace riedel
