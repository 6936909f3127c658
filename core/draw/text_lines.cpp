#include "core/draw/text_lines.hpp"

#include "core/draw/canvas.hpp"

#include <algorithm>
#include <map>

namespace riedel {

namespace {

/// Whether a byte continues a letter of UTF-8.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

void drop_last_letter(std::string& text) {
  while (!text.empty() && continues(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

std::size_t end_of_letter(const std::string& text, std::size_t start) {
  std::size_t end = start + 1;
  while (end < text.size() && continues(text[end])) ++end;
  return end;
}

/// Additional width by a letter, in font sizes. Querying fonts is slow.
double advance(const std::string& letter) {
  static std::map<std::string, double> known;
  const auto found = known.find(letter);
  if (found != known.end()) return found->second;
  return known[letter] = text_width("x" + letter + "x", 1.0) - text_width("xx", 1.0);
}

/// The longest beginning that fits, at least one letter: up to a space if there is one, which is dropped.
std::string cut_off(std::string& text, double size, double width) {
  std::size_t end = 0, space = 0;
  for (double wide = 0; end < text.size();) {
    const std::size_t next = end_of_letter(text, end);
    if (text[end] == ' ') space = end;
    wide += size * advance(text.substr(end, next - end));
    if (end > 0 && wide > width) break;
    end = next;
  }
  if (end == text.size()) space = 0;
  const std::string line = text.substr(0, space > 0 ? space : end);
  text.erase(0, space > 0 ? space + 1 : end);
  return line;
}

} // namespace

std::vector<std::string> lines_of(const std::string& text, double size, double width, std::size_t maximum) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (!rest.empty() && lines.size() < maximum) lines.push_back(cut_off(rest, size, width));
  if (rest.empty() || lines.empty()) return lines;
  std::string& last = lines.back();
  while (!last.empty() && text_width(last + "…", size) > width) drop_last_letter(last);
  last += "…";
  return lines;
}

double widest(const std::vector<std::string>& texts, double size) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(text, size));
  return width;
}

} // namespace riedel
