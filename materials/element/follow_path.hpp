/// An element test at one point.
#pragma once

#include "materials/element/path.hpp"
#include "materials/element/rows.hpp"

namespace riedel {

/// Accuracy and output of a test at one point.
struct PathControl {
  double tolerance;    ///< error allowed in a step, relative to the stress and to the strain of the step [-]
  double every_strain; ///< maximum strain between rows [-]
  double void_ratio;   ///< at the start, for a law without it [-]
};

/// Leads a point of a law along a path under mixed control. A stage in which the law cannot follow ends the curve,
/// whose `failure` states why.
/// @param start stress and state; its stress is that of the path
ElementCurve follow_path(const Material& law, const MaterialPoint& start, const ElementPath& path,
                         const PathControl& control, const ElementWatch& watch);

} // namespace riedel
