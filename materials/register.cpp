#include "materials/register.hpp"

#include "materials/gudehus_bauer.hpp"
#include "materials/intergranular_strain.hpp"
#include "materials/linear_elastic.hpp"
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

/// A hypoplastic law, with intergranular strain where the case asks for it.
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
                  const Extension checked(given, Law::name); // a wrong value is not let pass where it has no effect
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
}

} // namespace riedel
