#include "materials/kit/strength.hpp"

namespace riedel {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
const Bounds angle{.lower = 0.0, .upper = 90.0, .upper_included = false};

double residual(const Values& given, const std::string& name) {
  return given.is_text(name + "_residual") ? given.number(name) : given.number(name + "_residual");
}

void check_order(const Values& given, std::string_view owner, const std::string& lesser, const std::string& greater) {
  const double low = given.is_text(lesser) ? 0.0 : given.number(lesser), high = given.number(greater);
  if (low > high)
    throw InputError(std::string(owner) + ": " + lesser + " = " + exact_text(low) + " exceeds " + greater +
                     "; allowed: [0, " + exact_text(high) + "]" + (greater == "cohesion" ? " Pa" : " deg"));
}
} // namespace

Keys FrictionalStrength::keys() {
  const std::vector<std::string> peak{"peak"};
  return {
      {"cohesion", 5e3, "Pa", at_least(0), "cohesion c"},
      {"cohesion_residual", "peak", "Pa", at_least(0), "cohesion after softening", peak},
      {"friction_angle", 30.0, "deg", angle, "angle of friction φ"},
      {"friction_angle_residual", "peak", "deg", angle, "angle of friction after softening", peak},
      {"dilatancy_angle", 0.0, "deg", angle, "angle of dilatancy ψ"},
      {"dilatancy_angle_residual", "peak", "deg", angle, "angle of dilatancy after softening", peak},
      {"softening_strain", 0.1, "-", more_than(0),
       "plastic deviatoric strain at which the residual values are reached"},
      {"tension_cutoff", "off", "Pa", at_least(0), "maximum tension", {"off"}},
  };
}

FrictionalStrength::FrictionalStrength(const Values& given, std::string_view owner)
    : peak_{given.number("cohesion"), degree * given.number("friction_angle"),
            degree * given.number("dilatancy_angle")},
      residual_{residual(given, "cohesion"), degree * residual(given, "friction_angle"),
                degree * residual(given, "dilatancy_angle")},
      softening_strain_(given.number("softening_strain")),
      tension_cutoff_(given.is_text("tension_cutoff") ? std::numeric_limits<double>::infinity()
                                                      : given.number("tension_cutoff")) {
  check_bounds(keys(), given, owner);
  for (const std::string name : {"cohesion", "friction_angle", "dilatancy_angle"})
    check_order(given, owner, name + "_residual", name);
  check_order(given, owner, "dilatancy_angle", "friction_angle");
  if (residual_.dilatancy > residual_.friction)
    throw InputError(
        std::string(owner) + ": the residual dilatancy angle, " + exact_text(residual_.dilatancy / degree) +
        " deg, exceeds the residual friction angle; allowed: [0, " + exact_text(residual_.friction / degree) + "] deg");
  if (residual_.cohesion == 0.0 && residual_.friction == 0.0)
    throw InputError(std::string(owner) + ": cohesion = 0 and friction_angle = 0 leave no strength, at the peak or " +
                     "after softening; allowed: one of them > 0");
}

bool FrictionalStrength::softens() const {
  return peak_.cohesion != residual_.cohesion || peak_.friction != residual_.friction ||
         peak_.dilatancy != residual_.dilatancy;
}

} // namespace riedel
