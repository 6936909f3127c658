/// A slab of points as a picture in the plane.
#pragma once

#include "core/io/frame.hpp"

#include <cstdint>

namespace riedel {

/// The mean over the depth z of points that stand in layers, one layer's numbers after the other's and in the same
/// order. Volume and mass are summed, per metre of depth; domains are those in the plane,
/// and the points have no ids.
/// @param depth of the slab [m]
Frame mean_over_depth(const Frame& slab, std::int64_t layers, double depth);

} // namespace riedel
