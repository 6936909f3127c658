/// A sheet to draw on, as pixels or as SVG, so that both share one layout.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace riedel {

/// A position on the sheet, from its upper left corner, in units of the layout (one pixel at scale 1).
struct Spot {
  double x = 0, y = 0;
};

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// Red, green and blue from 0 to 1.
struct Color {
  double r = 0, g = 0, b = 0;
};
constexpr Color black{0, 0, 0}, white{1, 1, 1};
constexpr Color ink{0.15, 0.15, 0.15}; ///< axes and text, softer than black

struct Pen {
  Color color = ink;
  double width = 1;
  std::vector<double> dashes = {}; ///< lengths drawn and skipped in turn; empty: a solid line
};

enum class Anchor { start, middle, end };

struct Lettering {
  double size = 13; ///< height of the font
  Color color = ink;
  Anchor anchor = Anchor::start; ///< which part of the text is at the spot
  bool upright = false;          ///< reads from bottom to top
};

class Canvas {
public:
  virtual ~Canvas() = default;
  /// With round joins and ends.
  virtual void line(const std::vector<Spot>& spots, const Pen& pen) = 0;
  virtual void disc(Spot centre, double radius, Color color) = 0;
  virtual void rectangle(const Box& box, Color color) = 0;
  /// @param at on the base line of the text
  virtual void text(Spot at, const std::string& text, const Lettering& lettering) = 0;
  /// Subsequent drawing belongs to this id; empty: to none. Ignored by formats that cannot express it.
  virtual void belongs_to(const std::string& /*id*/) {}
  /// The bytes of the file.
  [[nodiscard]] virtual std::string encode() const = 0;
};

std::unique_ptr<Canvas> make_svg_canvas(double width, double height);

/// Coverage of each pixel by a text, row by row from the top, 0 to 255.
struct TextMask {
  int width = 0, height = 0;
  int baseline = 0; ///< row of the base line, from the top
  std::vector<unsigned char> cover;
};
/// Text in the font of all drawings; Greek letters are spelled out if only VTK's built-in font is available.
TextMask text_mask(const std::string& text, double size);
/// Width of a text in that font, on every canvas.
double text_width(const std::string& text, double size);

/// A PNG file's bytes. @param rgb row by row from the top
std::string encode_png(int width, int height, const std::vector<unsigned char>& rgb);

} // namespace riedel
