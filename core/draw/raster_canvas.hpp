/// A canvas of pixels, antialiased, for PNG files.
#pragma once

#include "core/draw/canvas.hpp"

namespace riedel {

class RasterCanvas final : public Canvas {
public:
  /// @param scale pixels per unit of the layout
  RasterCanvas(double width, double height, double scale = 1);

  void line(const std::vector<Spot>& spots, const Pen& pen) override;
  void disc(Spot centre, double radius, Color color) override;
  void rectangle(const Box& box, Color color) override;
  void text(Spot at, const std::string& text, const Lettering& lettering) override;
  [[nodiscard]] std::string encode() const override;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Blends a colour over one pixel; pixels outside the sheet are ignored. @param cover 0 (nothing) to 1 (opaque)
  void blend(int x, int y, Color color, double cover);

private:
  void stroke(const std::vector<Spot>& spots, double half_width, Color color);

  int width_, height_;
  double scale_;
  std::vector<Color> pixels_;
};

} // namespace riedel
