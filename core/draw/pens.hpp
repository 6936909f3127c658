/// Colours, dashes and markers that tell the curves of a plot apart.
#pragma once

#include "core/draw/canvas.hpp"

namespace riedel {

/// The n-th of ten colours, again and again: seven that the colour-blind can tell apart, then three darker ones.
Color palette_color(std::size_t number);

/// The n-th of eight patterns of dashes, again and again; the first is a whole line.
std::vector<double> dash_pattern(std::size_t number);

/// The pen of the n-th curve that has neither colour nor style of its own: the palette again and again, with other
/// dashes each time.
Pen series_pen(std::size_t number);

/// The pen of a curve that two things tell apart: the colour says the one, the dashes the other. Once the dashes are
/// used up the colour is paler.
Pen pen_of_two(std::size_t color, std::size_t dashes);

/// Nearer to white. @param part 0: as it is, 1: white
Color paler(Color color, double part);

enum class Marker { none, disc, square, diamond, triangle, cross };

/// The n-th of the five, again and again.
Marker marker_of(std::size_t number);

/// @param color of its outline; a disc is filled
void draw_marker(Canvas& canvas, Marker marker, Spot centre, Color color);

} // namespace riedel
