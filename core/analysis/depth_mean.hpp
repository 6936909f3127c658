/// Reduces a three-dimensional slab of points to the plane.
#pragma once

#include "core/io/frame.hpp"

namespace riedel {

/// The mean over the depth z of points that lay behind one another at the start. Volume and mass are summed, per metre
/// of depth; domains are projected onto the plane; the points have neither ids nor bodies. Columns are in the order of
/// their first points.
/// @param depth of the slab [m]   @throws InputError for a frame without displacements
Frame mean_over_depth(const Frame& slab, double depth);

/// Extent of the domains along z [m].
double depth_of(const Frame& slab);

} // namespace riedel
