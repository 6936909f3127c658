/// Colours, dashes and markers that distinguish the curves of a plot.
#pragma once

#include "core/draw/canvas.hpp"

namespace riedel {

/// The n-th of ten colours, repeating: seven that are distinguishable with colour-blindness, then three darker ones.
Color palette_color(std::size_t number);

/// The n-th of eight dash patterns, repeating; the first is a solid line.
std::vector<double> dash_pattern(std::size_t number);

/// The pen of the n-th curve that has neither colour nor style of its own: the palette, repeated with other dashes.
Pen series_pen(std::size_t number);

/// The pen of a curve that is distinguished by two properties: one by colour, the other by dashes. When the dashes are
/// used up, the colour becomes paler.
Pen pen_of_two(std::size_t color, std::size_t dashes);

/// Mixes a colour with white. @param part 0: unchanged, 1: white
Color paler(Color color, double part);

enum class Marker { none, disc, square, diamond, triangle, cross };

/// The n-th of five markers, repeating.
Marker marker_of(std::size_t number);

/// @param color of the outline; a disc is filled
void draw_marker(Canvas& canvas, Marker marker, Spot centre, Color color);

} // namespace riedel
