/// Replaces canvas.cpp in a build without VTK: drawings as SVG, with estimated text widths.
#include "core/base/error.hpp"
#include "core/draw/canvas.hpp"
#include "core/io/with_vtk.hpp"

#include <algorithm>

namespace riedel {

double text_width(const std::string& text, double size) {
  constexpr double usual = 0.6; // width of a letter of DejaVu Sans over the font's height
  const auto letters = std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }); // of UTF-8
  return usual * size * static_cast<double>(letters);
}

TextMask text_mask(const std::string&, double) { throw RunError("a picture (PNG) " + std::string(takes_vtk)); }

std::string encode_png(int, int, const std::vector<unsigned char>&) {
  throw RunError("a picture (PNG) " + std::string(takes_vtk));
}

} // namespace riedel
