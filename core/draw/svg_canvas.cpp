#include "core/draw/canvas.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace riedel {
namespace {

/// Hundredths are finer than the resolution of any screen or printer.
std::string number(double value) {
  const long long hundredths = std::llround(value * 100);
  const long long whole = std::llabs(hundredths) / 100, rest = std::llabs(hundredths) % 100;
  std::string text = (hundredths < 0 ? "-" : "") + std::to_string(whole);
  if (rest != 0) text += "." + std::string(rest < 10 ? "0" : "") + std::to_string(rest);
  return text.ends_with('0') && rest != 0 ? text.substr(0, text.size() - 1) : text;
}

std::string attribute(const std::string& name, const std::string& value) { return " " + name + "=\"" + value + "\""; }
std::string attribute(const std::string& name, double value) { return attribute(name, number(value)); }

std::string hex(Color color) {
  std::array<char, 8> text{};
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(255 * part)) & 255U; };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return text.data();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

class SvgCanvas final : public Canvas {
public:
  SvgCanvas(double width, double height) : width_(width), height_(height) { rectangle({0, 0, width, height}, white); }

  void line(const std::vector<Spot>& spots, const Pen& pen) override {
    std::string points;
    for (const Spot& s : spots) points += (points.empty() ? "" : " ") + number(s.x) + "," + number(s.y);
    std::string dashes;
    for (double dash : pen.dashes) dashes += (dashes.empty() ? "" : " ") + number(dash);
    body_ += "<polyline" + attribute("points", points) + attribute("fill", "none") +
             attribute("stroke", hex(pen.color)) + attribute("stroke-width", pen.width) +
             (dashes.empty() ? "" : attribute("stroke-dasharray", dashes)) + "/>\n";
  }

  void disc(Spot centre, double radius, Color color) override {
    body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) +
             attribute("fill", hex(color)) + "/>\n";
  }

  void rectangle(const Box& box, Color color) override {
    body_ += "<rect" + attribute("x", box.left) + attribute("y", box.top) + attribute("width", box.width()) +
             attribute("height", box.height()) + attribute("fill", hex(color)) + "/>\n";
  }

  void text(Spot at, const std::string& text, const Lettering& lettering) override {
    constexpr std::array<const char*, 3> anchors{"start", "middle", "end"};
    const std::string turn = "rotate(-90 " + number(at.x) + " " + number(at.y) + ")";
    body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", lettering.size) +
             attribute("fill", hex(lettering.color)) +
             attribute("text-anchor", anchors[static_cast<std::size_t>(lettering.anchor)]) +
             (lettering.upright ? attribute("transform", turn) : "") + ">" + escaped(text) + "</text>\n";
  }

  void belongs_to(const std::string& id) override {
    if (in_group_) body_ += "</g>\n";
    in_group_ = !id.empty();
    if (in_group_) body_ += "<g" + attribute("data-run", escaped(id)) + ">\n";
  }

  [[nodiscard]] std::string encode() const override {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
           attribute("width", width_) + attribute("height", height_) +
           attribute("viewBox", "0 0 " + number(width_) + " " + number(height_)) +
           " font-family=\"DejaVu Sans, Verdana, Helvetica, sans-serif\" stroke-linecap=\"round\""
           " stroke-linejoin=\"round\">\n" +
           body_ + (in_group_ ? "</g>\n" : "") + "</svg>\n";
  }

private:
  double width_, height_;
  std::string body_;
  bool in_group_ = false;
};

} // namespace

std::unique_ptr<Canvas> make_svg_canvas(double width, double height) {
  return std::make_unique<SvgCanvas>(width, height);
}

} // namespace riedel
