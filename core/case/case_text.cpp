#include "core/case/case_text.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::string in_quotes(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string answer = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (answer += '\\') += c;
    else if (code < 0x20 || code == 0x7f)
      ((answer += "\\u00") += digits[code / 16]) += digits[code % 16];
    else
      answer += c;
  }
  return answer + "\"";
}

struct ToText {
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(std::int64_t integer) const { return std::to_string(integer); }
  std::string operator()(double real) const { return exact_text(real); }
  std::string operator()(const std::string& text) const { return in_quotes(text); }
  template <class Number>
  std::string operator()(const std::vector<Number>& list) const {
    std::string text;
    for (const Number& number : list) text += (text.empty() ? "" : ", ") + (*this)(number);
    return "[" + text + "]";
  }
};

std::string_view section_of(const Key& key) {
  const std::size_t dot = key.name.rfind('.');
  return dot == std::string::npos ? std::string_view{} : std::string_view(key.name).substr(0, dot);
}

std::string comment(const Key& key) {
  std::string text = key.doc;
  if (!key.unit.empty() && key.unit != "-") text += " [" + key.unit + "]";
  for (std::size_t i = 0; i < key.choices.size(); ++i) text += (i == 0 ? ": " : " | ") + key.choices[i];
  if (!key.choices.empty() && key.takes_number()) text += " | a number";
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string line(const Key& key, const Value& value) {
  constexpr std::size_t column = 40; // where comments begin
  std::string text = key.name.substr(key.name.rfind('.') + 1) + " = " + toml_text(value);
  text.resize(std::max(text.size() + 1, column), ' ');
  return text + "# " + comment(key) + "\n";
}

} // namespace

std::string toml_text(const Value& value) { return std::visit(ToText{}, value); }

std::string case_text(const Keys& keys, const Values& values) {
  std::vector<std::string_view> sections{""}; // keys without a section must come first in TOML
  for (const Key& key : keys)
    if (std::ranges::find(sections, section_of(key)) == sections.end()) sections.push_back(section_of(key));
  std::string text =
      "# Every key in force. SI units; texts with units (\"1.5 mm\", \"50 kPa\") are understood as well.\n";
  for (const std::string_view section : sections) {
    if (!section.empty()) text += "\n[" + std::string(section) + "]\n";
    for (const Key& key : keys)
      if (section_of(key) == section) text += line(key, values.at(key.name));
  }
  return text;
}

} // namespace riedel
