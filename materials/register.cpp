#include "materials/register.hpp"

#include "materials/drucker_prager.hpp"
#include "materials/gudehus_bauer.hpp"
#include "materials/intergranular_strain.hpp"
#include "materials/linear_elastic.hpp"
#include "materials/mohr_coulomb.hpp"
#include "materials/neo_hookean.hpp"
#include "materials/umat.hpp"
#include "materials/von_wolffersdorff.hpp"

namespace riedel {

namespace {
template <class Law>
void add(Materials& materials, std::string summary, std::string source) {
  materials.add({.name = std::string(Law::name),
                 .summary = std::move(summary),
                 .source = std::move(source),
                 .parameters = Law::parameters()},
                [](const Values& given) { return std::make_unique<Law>(given); });
}

/// A hypoplastic law, with intergranular strain if the case requests it.
template <class Law>
void add_hypoplastic(Materials& materials, std::string summary, std::string source) {
  using Extension = IntergranularStrainParameters;
  Keys parameters = Law::parameters();
  const Keys more = Extension::keys();
  parameters.insert(parameters.end(), more.begin(), more.end());
  materials.add({.name = std::string(Law::name),
                 .summary = std::move(summary),
                 .source = std::move(source),
                 .parameters = std::move(parameters)},
                [](const Values& given) -> std::unique_ptr<Material> {
                  const Extension checked(given, Law::name); // a wrong value is an error even if it has no effect
                  if (given.flag(Extension::chosen)) return std::make_unique<IntergranularStrain<Law>>(given);
                  return std::make_unique<Law>(given);
                });
}
} // namespace

void register_materials(Materials& materials) {
  add<LinearElastic>(materials, "Hooke's law in rates", "");
  add_hypoplastic<GudehusBauer>(materials, "hypoplastic sand, local or non-local (averages rate_norm)",
                                "Gudehus (1996), Bauer (1996); intergranular strain: Niemunis & Herle (1997)");
  add_hypoplastic<VonWolffersdorff>(
      materials,
      "hypoplastic sand with the critical states of Matsuoka and Nakai, local or non-local (averages rate_norm)",
      "von Wolffersdorff (1996); intergranular strain: Niemunis & Herle (1997)");
  add<NeoHookean>(materials, "elasticity at finite strain, from an energy", "Simo & Pister (1984)");
  add<MohrCoulomb>(materials, "elastic, with friction and cohesion; softening local or by averaged plastic_strain",
                   "Clausen, Damkilde & Andersen (2006), de Souza Neto, Perić & Owen (2008)");
  add<DruckerPrager>(materials, "as mohr_coulomb, on a smooth cone", "Drucker & Prager (1952)");
  add<Umat>(materials, "a user's subroutine UMAT, written for Abaqus, in a shared library", "");
}

} // namespace riedel
