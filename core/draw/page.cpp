#include "core/draw/page.hpp"

#include "core/draw/page_style.hpp"
#include "core/draw/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace riedel {

namespace {

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + html_escaped(value) + "\"";
}

std::string element(const std::string& tag, const std::string& attributes, const std::string& inside) {
  return "<" + tag + attributes + ">" + inside + "</" + tag + ">";
}

std::string run_attribute(const std::string& run) { return run.empty() ? "" : attribute("data-run", run); }

std::string hex(const Color& color) {
  std::array<char, 8> text{};
  const auto byte = [](double part) { return static_cast<unsigned>(std::lround(255 * part)) & 255U; };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return text.data();
}

/// A short sample of the curve.
std::string swatch(const Pen& pen) {
  std::string dashes;
  for (const double dash : pen.dashes) dashes += (dashes.empty() ? "" : " ") + std::to_string(dash);
  return "<svg class=\"swatch\" viewBox=\"0 0 26 8\" aria-hidden=\"true\"><line x1=\"2\" y1=\"4\" x2=\"24\" y2=\"4\"" +
         attribute("stroke", hex(pen.color)) + " stroke-width=\"2.5\" stroke-linecap=\"round\"" +
         (dashes.empty() ? "" : attribute("stroke-dasharray", dashes)) + "/></svg>";
}

/// The SVG of a plot inside a page: without XML header, and as wide as the room available.
std::string inline_svg(const Plot& plot) {
  std::string svg = svg_text(plot);
  svg.erase(0, svg.find("<svg"));
  return svg.insert(4, " role=\"img\"" + attribute("aria-label", plot.y_label + " over " + plot.x_label));
}

constexpr double bar_left = 24, bar_width = 304; ///< of the colours in the colour bar's picture

/// Ticks and labels of the bar, as many as fit.
std::string bar_ticks(const Interval& range) {
  constexpr double font = 11;
  std::vector<double> values;
  std::vector<std::string> labels;
  for (int about = 6; about > 0; --about) {
    values = round_ticks(range, about);
    labels = tick_labels(values);
    const double needed = widest(labels, font) + 0.7 * font;
    if (values.size() < 2 || needed <= (range.part(values[1]) - range.part(values[0])) * bar_width) break;
  }
  std::string ticks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double middle = bar_left + range.part(values[i]) * bar_width, half = 0.5 * text_width(labels[i], font);
    const std::string x = std::to_string(middle);
    ticks += "<line" + attribute("x1", x) + attribute("x2", x) + " y1=\"16\" y2=\"20\" stroke=\"#262626\"/><text" +
             attribute("x", std::to_string(std::clamp(middle, half, bar_width + 2 * bar_left - half))) +
             " y=\"31\" text-anchor=\"middle\">" + labels[i] + "</text>";
  }
  return ticks;
}

/// @param id of its gradient, unique on the page
std::string color_bar(const PagePictures& p, const std::string& id) {
  constexpr int stops = 16;
  std::string gradient;
  for (int i = 0; i <= stops; ++i) {
    const double part = static_cast<double>(i) / stops;
    gradient +=
        "<stop" + attribute("offset", std::to_string(part)) + attribute("stop-color", hex(viridis(part))) + "/>";
  }
  return "<svg class=\"bar\" viewBox=\"0 0 352 36\"" + attribute("aria-label", p.label) + "><defs><linearGradient" +
         attribute("id", id) + ">" + gradient + "</linearGradient></defs><rect" +
         attribute("x", std::to_string(bar_left)) + " y=\"4\"" + attribute("width", std::to_string(bar_width)) +
         " height=\"12\"" + attribute("fill", "url(#" + id + ")") + "/>" + bar_ticks(p.range) + "</svg>";
}

} // namespace

std::string html_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::heading(const std::string& text) { body_ += element("h2", "", html_escaped(text)) + "\n"; }
void Page::subheading(const std::string& text) { body_ += element("h3", "", html_escaped(text)) + "\n"; }
void Page::paragraph(const std::string& text) { body_ += element("p", "", html_escaped(text)) + "\n"; }

void Page::facts(const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::string list;
  for (const auto& [name, what] : pairs)
    list += element("dt", "", html_escaped(name)) + element("dd", "", html_escaped(what)) + "\n";
  body_ += element("dl", "", list) + "\n";
}

void Page::table(const PageTable& table) {
  std::string head, rows;
  for (std::size_t c = 0; c < table.header.size(); ++c)
    head += element("th", " scope=\"col\"" + std::string(c < table.text_columns ? " class=\"text\"" : ""),
                    html_escaped(table.header[c]));
  for (const PageRow& row : table.rows) {
    std::string cells;
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      const bool text = table.long_text || c < table.text_columns;
      const std::string look = (text ? "text " : "") + row.cells[c].look;
      const std::string name = c == 0 ? "th" : "td";
      cells +=
          element(name, (c == 0 ? " scope=\"row\"" : "") + attribute("class", look), html_escaped(row.cells[c].text));
    }
    rows += element("tr", run_attribute(row.run), cells) + "\n";
  }
  const std::string caption = "caption" + std::to_string(body_.size());
  body_ += element("p", " class=\"caption\"" + attribute("id", caption), html_escaped(table.caption)) +
           "\n<div class=\"scroll\" tabindex=\"0\"" + attribute("aria-labelledby", caption) + " role=\"region\">" +
           element("table", (table.long_text ? " class=\"long\"" : "") + attribute("aria-labelledby", caption),
                   "\n" + element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", "\n" + rows)) +
           "</div>\n";
}

void Page::plot(const Plot& plot, const std::string& caption) {
  Plot bare = plot;
  std::string keys;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.id.empty()) continue;
    const Pen pen = pen_of(series, i);
    keys += element("button", " type=\"button\" aria-pressed=\"false\"" + run_attribute(series.id),
                    swatch(pen) + html_escaped(series.label)) +
            "\n";
    bare.series[i].label.clear();
  }
  body_ += element("figure", " class=\"plot\"",
                   element("div", " class=\"sheet\"", inline_svg(bare)) + "\n" +
                       (keys.empty() ? "" : element("div", " class=\"keys\"", keys)) +
                       element("figcaption", "", html_escaped(caption))) +
           "\n";
}

void Page::pictures(const PagePictures& p) {
  std::string all;
  for (const PagePicture& picture : p.pictures)
    all +=
        element("figure", run_attribute(picture.run) + attribute("style", "width:" + std::to_string(p.width_px) + "px"),
                "<img" + attribute("alt", p.label + ", " + picture.caption) +
                    attribute("src", "data:image/png;base64," + base64(picture.png)) + ">" +
                    element("figcaption", "", html_escaped(picture.caption))) +
        "\n";
  body_ += element("figure", " class=\"pictures\"",
                   element("div", " class=\"row\"", all) +
                       element("div", " class=\"colors\"",
                               element("span", "", html_escaped(p.label)) +
                                   color_bar(p, "colors" + std::to_string(body_.size()))) +
                       element("figcaption", "", html_escaped(p.caption))) +
           "\n";
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         element("title", "", html_escaped(title_)) + "\n" + element("style", "", page_style()) +
         "\n</head>\n<body>\n" + element("h1", "", html_escaped(title_)) + "\n" + element("main", "", "\n" + body_) +
         "\n" + element("script", "", page_script()) + "\n</body>\n</html>\n";
}

} // namespace riedel
