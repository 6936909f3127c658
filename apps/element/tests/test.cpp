#include "apps/element/tests/test.hpp"

namespace riedel {

Key element_pressure_key(const std::string& name, double standard, std::string doc) {
  return {"loading." + name, standard, "Pa", more_than(0), std::move(doc)};
}

Key element_strain_key(double standard, const std::string& doc, double maximum) {
  return {"loading.final_strain", standard, "-", within(0, maximum), doc};
}

namespace picture_axes {
PictureAxis eps_1() { return {"eps_1", "vertical strain ε₁ [%]", 100.0}; }
PictureAxis gamma() { return {"gamma", "shear strain γ = u/h₀ [%]", 100.0}; }
PictureAxis sigma_1() { return {"sigma_1_Pa", "vertical stress σ₁ [kPa]", 1e-3}; }
PictureAxis tau() { return {"tau_Pa", "shear stress τ [kPa]", 1e-3}; }
PictureAxis p() { return {"p_Pa", "effective mean pressure p [kPa]", 1e-3}; }
PictureAxis q() { return {"q_Pa", "q = σ₁ − (σ₂ + σ₃)/2 [kPa]", 1e-3}; }
PictureAxis phi() { return {"phi_mob_deg", "mobilised friction angle φ [°]"}; }
PictureAxis void_ratio() { return {"void_ratio", "void ratio e [-]"}; }
} // namespace picture_axes

std::vector<ElementPicture> pictures_of_compression() {
  return {{"stress_strain.png", picture_axes::eps_1(), picture_axes::sigma_1()},
          {"friction.png", picture_axes::eps_1(), picture_axes::phi()},
          {"void_ratio.png", picture_axes::eps_1(), picture_axes::void_ratio()},
          {"compression.png", picture_axes::sigma_1(), picture_axes::void_ratio(), true},
          {"p_q.png", picture_axes::p(), picture_axes::q()}};
}

} // namespace riedel
