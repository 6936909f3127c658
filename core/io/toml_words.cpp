#include "core/io/toml_words.hpp"

#include "core/io/readable.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace riedel {

namespace {

constexpr std::string_view blank = " \t\r\n";
constexpr std::size_t longest_shown = 40;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Position after the quotes that end a text at `at`; three quotes may follow one or two that belong to the text.
std::size_t end_of_fence(std::string_view text, std::size_t at, std::size_t wide) {
  std::size_t end = at + wide;
  for (int own = 0; wide == 3 && own < 2 && end < text.size() && text[end] == text[at]; ++own) ++end;
  return end;
}

/// End of the quoted text at the start of the view, including its quotes.
std::size_t end_of_quoted(std::string_view text) {
  const char quote = text.front();
  const std::string fence(3, quote);
  const std::size_t wide = text.size() >= 3 && text[1] == quote && text[2] == quote ? 3 : 1;
  for (std::size_t i = wide; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (text.substr(i).starts_with(std::string_view(fence).substr(0, wide)))
      return end_of_fence(text, i, wide);
  }
  return text.size();
}

/// Replaces every quoted sign by a space, and with `comments` every sign of a comment except #.
std::string without(std::string_view text, bool comments) {
  std::string plain(text);
  const auto blank_out = [&](std::size_t begin, std::size_t end) {
    std::replace_if(
        plain.begin() + static_cast<std::ptrdiff_t>(begin), plain.begin() + static_cast<std::ptrdiff_t>(end),
        [](char c) { return c != '\n'; }, ' ');
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool comment = text[i] == '#'; // a quote in a comment does not begin a text
    if (!comment && text[i] != '"' && text[i] != '\'') continue;
    const std::size_t end = comment ? std::min(text.find('\n', i), text.size()) : i + end_of_quoted(text.substr(i));
    if (!comment) blank_out(i, end);
    if (comment && comments) blank_out(i + 1, end);
    i = end - 1;
  }
  return plain;
}

/// What follows the equals sign, or the whole line if it continues a list; without a comment.
std::string_view value_in(std::string_view line) {
  const std::string plain = without_quoted(line);
  const std::size_t equals = plain.find('='), end = std::min(plain.find('#'), plain.size());
  const std::size_t begin = equals == std::string::npos || equals > end ? 0 : equals + 1;
  return trimmed(line.substr(begin, end - begin));
}

std::vector<std::string_view> items_of(std::string_view value) {
  std::vector<std::string_view> items;
  while (!value.empty()) {
    const std::size_t end = std::min(value.find_first_of(",[]{}"), value.size());
    if (const std::string_view item = trimmed(value.substr(0, end)); !item.empty()) items.push_back(item);
    value.remove_prefix(std::min(end + 1, value.size()));
  }
  return items;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

/// A number followed by a letter, with or without a blank: "1.5 mm", but no date and no 1e400.
bool is_quantity(std::string_view item) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), number);
  if (error == std::errc::invalid_argument) return false;
  const std::string_view rest = trimmed(item.substr(static_cast<std::size_t>(end - item.data())));
  return !rest.empty() && (is_letter(rest.front()) || rest.front() == '%');
}

} // namespace

bool is_bare_word(std::string_view word) {
  const auto plain = [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; };
  return !word.empty() && std::ranges::all_of(word, plain);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blank);
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::string without_quoted(std::string_view text) { return without(text, false); }

std::string without_texts(std::string_view text) { return without(text, true); }

std::string toml_hint(std::string_view line) {
  const std::string_view value = value_in(line);
  if (value.empty() || value.find_first_of("\"'") != std::string_view::npos || trimmed(line).starts_with('['))
    return "";
  const bool list = value.find_first_of("[]") != std::string_view::npos;
  const std::vector<std::string_view> items = items_of(value);
  if (!list && items.size() > 1 && is_digit(items[0].back()) && is_digit(items[1].front()))
    return "; a number has a point, not a comma, and a list needs [brackets]";
  for (const std::string_view item : items) {
    const std::string small = in_small_letters(item);
    constexpr std::array<std::string_view, 4> words{"true", "false", "inf", "nan"};
    if (std::ranges::find(words, item) != words.end()) continue;
    if (std::ranges::find(words, small) != words.end()) return "; write it in lower case: " + small;
    if (is_quantity(item)) return "; a number with a unit needs quotes: \"" + readable(item, longest_shown) + "\"";
    if (is_letter(item.front())) return "; a text needs quotes: \"" + readable(item, longest_shown) + "\"";
  }
  return "";
}

} // namespace riedel
