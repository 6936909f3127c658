/// Locates the points on the grid: their stencils, and an order in which threads do not conflict.
#pragma once

#include "core/step/model.hpp"

namespace riedel {

/// Allocates stencils and nodes for the state's points and grid, and sorts the points.
template <int Dim>
void prepare_points(State<Dim>& state, const Model<Dim>& model);

/// At the start of a step: stencils, and now and then a check whether the points are still in order.
template <int Dim>
void locate_points(State<Dim>& state, const Model<Dim>& model);

/// Before the first step, with the points located: throws InputError naming the first point whose support leaves the
/// grid.
template <int Dim>
void check_inside(State<Dim>& state, const Model<Dim>& model);

/// From this call on, the stencils of all points are kept from the start of a step to its end.
template <int Dim>
void keep_stencils(State<Dim>& state, const Model<Dim>& model);

/// For points that leave the rows of their slab: sorts them again, into thicker slabs if that has already been tried.
/// Throws RunError naming the first point whose support leaves the grid.
template <int Dim>
void sort_strays(State<Dim>& state, const Model<Dim>& model, bool thicker);

} // namespace riedel
