#include "apps/key_tables.hpp"

#include "apps/biaxial_keys.hpp"
#include "core/io/case_text.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

std::string section_of(const Key& key) { return key.name.substr(0, key.name.rfind('.') + 1); }

std::string unit_of(const Key& key) { return key.unit == "-" ? "" : key.unit; }

/// What is allowed: "gimp | cpdi", "> 0", "in (0, 1)", "auto | > 0", or nothing.
std::string allowed(const Key& key) {
  std::string text;
  for (const std::string& choice : key.choices) text += (text.empty() ? "" : " | ") + choice;
  if (!std::isfinite(key.bounds.lower) && !std::isfinite(key.bounds.upper)) return text;
  const std::string range = key.bounds.text();
  return text + (text.empty() ? "" : " | ") + (range.front() == '(' || range.front() == '[' ? "in " : "") + range;
}

/// Length as seen: bytes that continue a letter do not count.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(std::max(width, letters(text) + 2) - letters(text), ' ');
}

std::string help_line(const Key& key) {
  const std::string range = allowed(key);
  return "  " + padded(key.name, 28) + padded(toml_text(key.default_value) + " " + unit_of(key), 26) + key.doc +
         (range.empty() ? "" : ": " + range) + "\n";
}

std::string markdown_line(const Key& key) {
  std::string range = allowed(key);
  for (std::size_t at = range.find('|'); at != std::string::npos; at = range.find('|', at + 2)) range.insert(at, "\\");
  return "| `" + key.name.substr(section_of(key).size()) + "` | " + unit_of(key) + " | `" +
         toml_text(key.default_value) + "` | " + range + " | " + key.doc + " |\n";
}

std::string markdown_table(const Keys& keys) {
  std::string text = "| key | unit | default | allowed | |\n|---|---|---|---|---|\n";
  for (const Key& key : keys) text += markdown_line(key);
  return text + "\n";
}

std::string law_section(const Description& law) {
  return "### `model = \"" + law.name + "\"`\n\n" + law.summary + ". " + law.source + ".\n\n" +
         (law.parameters.empty() ? "" : markdown_table(law.parameters));
}

} // namespace

std::string keys_help(const Keys& keys) {
  std::string text = "Keys of the case (default, what it is, what is allowed)\n"
                     "Numbers are SI (angles in degrees) or texts with a unit: \"50 kPa\", \"1.5 mm\", \"33 deg\".\n";
  std::string section = "none yet";
  for (const Key& key : keys) {
    if (section_of(key) != section) text += "\n";
    section = section_of(key);
    text += help_line(key);
  }
  return text + "\n'riedel list materials' shows the parameters of the other laws.\n";
}

std::string parameters_help(const Keys& parameters) {
  std::string text;
  for (const Key& key : parameters) text += "  " + help_line(key);
  return text;
}

std::string biaxial_reference(const Catalogue& catalogue) {
  std::string text =
      "# Keys of a biaxial case\n\nMade by `riedel check --reference` from the table that also checks the case. "
      "Every key has a default, the paper's value.\nNumbers are SI (angles in degrees) or texts with a unit: "
      "`\"50 kPa\"`, `\"1.5 mm\"`, `\"33 deg\"`.\n\n";
  const Keys keys = biaxial_keys(catalogue, paper_model);
  const auto& laws = catalogue.materials.entries();
  for (auto first = keys.begin(); first != keys.end();) {
    const std::string section = section_of(*first);
    const auto last = std::find_if(first, keys.end(), [&](const Key& key) { return section_of(key) != section; });
    text += section.empty() ? "## Without a section\n\n" : "## `[" + section.substr(0, section.size() - 1) + "]`\n\n";
    const bool is_material = section == "material."; // its first key is the model, the rest the law's
    text += markdown_table(Keys(first, is_material ? first + 1 : last));
    if (is_material)
      for (const auto& law : laws) text += law_section(law.description);
    first = last;
  }
  return text;
}

} // namespace riedel
