/// The path that a point follows: stages, each of several legs that may be repeated.
#pragma once

#include "materials/element/curve.hpp"
#include "materials/element/measures.hpp"

#include <optional>

namespace riedel {

/// "p < 20 kPa": what ends a stage early.
struct Stop {
  const Measure* measure;
  bool above; ///< ends the stage when the measure is above the limit; false: below
  double limit;

  [[nodiscard]] bool reached(const MaterialPoint& point, const PoreWater& water) const {
    const double value = measure->at(point, water);
    return above ? value > limit : value < limit;
  }
  [[nodiscard]] std::string text() const; ///< "p < 20000 Pa"
};

/// The value of a measure at the end of a leg; no target: it is kept constant.
struct Prescription {
  const Measure* measure;
  std::optional<double> target;
  double swing = 0.0, phase = 0.0; ///< of a sine added to the straight line, as in Condition; phase [rad]
};

struct PathLeg {
  std::vector<Prescription> prescriptions; ///< six, or none beside a deformation gradient
  std::optional<Mat<3>> deformation = {};  ///< from the start of the leg to its end
  bool relative = false;                   ///< targets are changes from the start of the leg
  double duration = 1.0;                   ///< [s]
  bool spin = true;                        ///< shears turn the normals of the sheared planes
};

struct PathStage {
  std::string name;
  std::vector<PathLeg> legs;
  std::int64_t repeat = 1;
  std::optional<Stop> until = {};
};

struct ElementPath {
  Sym<double> stress; ///< effective, at the start, tension positive [Pa]
  std::vector<PathStage> stages;
  Friction friction = Friction::principal; ///< definition of phi_mob
  PoreWater water = {};
};

/// The leg for a point at its start.
LoadStep leg_from(const PathLeg& leg, const MaterialPoint& point, const PoreWater& water);

} // namespace riedel
