#include "materials/element/path.hpp"

#include "core/base/parameters.hpp"

namespace riedel {

std::string Stop::text() const {
  return measure->name + (above ? " > " : " < ") + exact_text(limit) +
         (measure->unit == "-" ? "" : " " + measure->unit);
}

LoadStep leg_from(const PathLeg& leg, const MaterialPoint& point, const PoreWater& water) {
  LoadStep result{.conditions = {},
                  .duration = leg.duration,
                  .motion = leg.spin ? LoadStep::Motion::simple_shear : LoadStep::Motion::no_spin};
  if (leg.deformation) {
    result.motion = LoadStep::Motion::given;
    result.deformation = *leg.deformation;
    return result;
  }
  for (std::size_t c = 0; c < result.conditions.size(); ++c) {
    const auto& [measure, target, swing, phase] = leg.prescriptions.at(c);
    const double now = measure->at(point, water), start = leg.relative || !target ? now : 0.0;
    result.conditions[c] = condition(*measure, water, start + target.value_or(0.0));
    result.conditions[c].swing = swing;
    result.conditions[c].phase = phase;
  }
  return result;
}

} // namespace riedel
