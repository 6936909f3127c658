#include "materials/kit/elastoplastic_law.hpp"

namespace riedel {

Keys ElastoplasticControl::keys() {
  Keys keys = ElasticSolid::keys();
  keys.push_back({"strain_measure",
                  "small",
                  "",
                  {},
                  "stress increments with the objective rate, or logarithmic elastic strains",
                  {"small", "hencky"}});
  keys.push_back({"nonlocal_factor", 2.0, "-", at_least(1.0),
                  "m: softening by m times the averaged plus 1 - m times the point's own plastic strain"});
  return keys;
}

ElastoplasticControl::ElastoplasticControl(const Values& given)
    : solid(given),
      hencky(given.text("strain_measure") == "hencky"),
      nonlocal_factor(given.number("nonlocal_factor")) {}

/// The response to ε̇ is ε̇:C:ε̇ − (ε̇:C:r)(n:C:ε̇)/(n:C:r), and the product of two projections of a unit vector is at least
/// (u·w − ‖u‖‖w‖)/2.
double ElastoplasticControl::added_by(const FlowDirections& flow) const {
  const auto stiff = [&](const Vec<3>& e) -> Vec<3> {
    return solid.lambda * e.sum() * Vec<3>::Ones() + 2.0 * solid.mu * e;
  };
  const Vec<3> C_n = stiff(flow.normal), C_r = stiff(flow.flow);
  return 0.5 * (C_n.norm() * C_r.norm() - C_n.dot(C_r)) / flow.normal.dot(C_r);
}

Sym<double> ElastoplasticControl::trial(const Sym<double>& sigma, double volume_strain,
                                        const Sym<double>& strain) const {
  if (!hencky) return sigma + solid.stress(strain);
  const Sym<double> elastic = solid.strain(std::exp(volume_strain) * sigma); // ε_e = C⁻¹ τ, τ = J σ
  const Sym<double> b = isotropic_function(spectral(elastic), [](double e) { return std::exp(2.0 * e); });
  const Sym<double> stretch = isotropic_function(spectral(strain), [](double e) { return std::exp(e); });
  const Sym<double> moved = congruent(stretch, b); // exp(D Δt) b_e exp(D Δt)
  const Sym<double> after = isotropic_function(spectral(moved), [](double b_i) { return 0.5 * std::log(b_i); });
  return solid.stress(after) / std::exp(volume_strain + trace(strain));
}

} // namespace riedel
