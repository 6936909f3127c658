#include "core/case/key_tables.hpp"

#include "core/case/case_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace riedel {

namespace {

std::string unit_of(const Key& key) { return key.unit == "-" ? "" : key.unit; }

/// Length as displayed: continuation bytes of a letter do not count.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(std::max(width, letters(text) + 2) - letters(text), ' ');
}

std::string default_text(const Key& key) {
  const bool word = std::holds_alternative<std::string>(key.default_value);
  return toml_text(key.default_value) + (word || unit_of(key).empty() ? "" : " " + unit_of(key));
}

/// Words in lines of at most `width` letters, all but the first indented by a margin.
std::string wrapped(const std::string& text, std::size_t width, std::size_t margin) {
  std::istringstream words(text);
  std::string all, row;
  for (std::string word; words >> word; row += word) {
    if (!row.empty() && letters(row) + 1 + letters(word) > width) {
      all += row + "\n" + std::string(margin, ' ');
      row.clear();
    }
    if (!row.empty()) row += ' ';
  }
  return all + row;
}

/// Four columns; a long list of choices goes below the description.
std::string help_line(const Key& key, std::size_t indent) {
  constexpr std::size_t name = 28, value = 18, range = 12, doc = 58;
  const std::size_t margin = indent + name + value + range;
  const std::string choices = allowed(key);
  const bool fits = letters(choices) + 2 <= range;
  const std::string named = padded(std::string(indent, ' ') + key.name, indent + name);
  const std::string valued = padded(named + default_text(key), indent + name + value);
  return padded(valued + (fits ? choices : ""), margin) + wrapped(key.doc, doc, margin) + "\n" +
         (fits ? "" : std::string(margin, ' ') + wrapped(choices, doc, margin) + "\n");
}

constexpr const char* table_head = "| key | unit | default | allowed | |\n|---|---|---|---|---|\n";

std::string markdown_line(const Key& key, const std::string& name) {
  std::string range = allowed(key);
  for (std::size_t at = range.find('|'); at != std::string::npos; at = range.find('|', at + 2)) range.insert(at, "\\");
  return "| `" + name + "` | " + unit_of(key) + " | `" + toml_text(key.default_value) + "` | " + range + " | " +
         key.doc + " |\n";
}

} // namespace

std::string section_of(const Key& key) { return key.name.substr(0, key.name.rfind('.') + 1); }

bool has_source(const Description& description) { return !description.source.empty() && description.source != "-"; }

std::string allowed(const Key& key) {
  std::string text;
  for (const std::string& choice : key.choices) text += (text.empty() ? "" : " | ") + choice;
  if (!std::isfinite(key.bounds.lower) && !std::isfinite(key.bounds.upper)) return text;
  return text + (text.empty() ? "" : " | ") + key.bounds.text();
}

std::string keys_help(const Keys& keys, const std::string& whose) {
  std::string text = "Keys of the case " + whose +
                     "\nName, default, what is allowed, what it is; numbers are SI (angles in degrees) or texts with a "
                     "unit: \"50 kPa\", \"33 deg\"\n";
  std::string section = "none yet";
  for (const Key& key : keys) {
    if (section_of(key) != section) text += "\n";
    section = section_of(key);
    text += help_line(key, 2);
  }
  return text + "\n'riedel list' names the laws and the schemes, 'riedel list NAME' shows one with its parameters.\n";
}

std::string parameters_help(const Keys& parameters) {
  std::string text;
  for (const Key& key : parameters) text += help_line(key, 4);
  return text;
}

std::string keys_markdown(const Keys& keys) {
  std::string text = table_head;
  for (const Key& key : keys) text += markdown_line(key, key.name.substr(section_of(key).size()));
  return text + "\n";
}

std::string keys_markdown(const Keys& keys, std::span<const std::string_view> sections) {
  std::string text = table_head;
  for (const Key& key : keys)
    if (std::ranges::find(sections, section_of(key)) != sections.end()) text += markdown_line(key, key.name);
  return text + "\n";
}

} // namespace riedel
