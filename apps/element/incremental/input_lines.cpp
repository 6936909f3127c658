#include "apps/element/incremental/input_lines.hpp"

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"
#include "core/io/input_file.hpp"
#include "core/io/readable.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace riedel {

namespace {
constexpr std::size_t longest_shown = 80; ///< in messages [bytes]
} // namespace

InputLines::InputLines(const std::filesystem::path& path) : path_(path), file_(read_input_file(path)) {}

std::string InputLines::place() const { return path_.string() + ":" + std::to_string(number_) + ":"; }

void InputLines::refuse(const std::string& why) const { throw InputError(place() + " " + why); }

bool InputLines::next(std::string& line) {
  while (std::getline(file_, line)) {
    ++number_;
    if (line.find_first_not_of(" \t\r") != std::string::npos) return true;
  }
  return false;
}

std::string InputLines::line(const std::string& what) {
  std::string line;
  if (!next(line)) refuse("the file ends where " + what + " is expected");
  return line;
}

std::string InputLines::word(const std::string& what) {
  std::string first;
  std::istringstream(line(what)) >> first;
  return first;
}

std::vector<double> InputLines::numbers(std::size_t count, const std::string& what) {
  return numbers_in(line(what), count, what);
}

std::vector<double> InputLines::numbers_in(std::string line, std::size_t count, const std::string& what) const {
  std::ranges::replace(line, ',', ' ');
  std::istringstream words(line);
  std::vector<double> all;
  for (std::string text; all.size() < count && words >> text;) all.push_back(number_in(text, what));
  if (all.size() < count) refuse("needs " + what);
  return all;
}

std::int64_t InputLines::integer(const std::string& what, std::int64_t minimum, std::int64_t maximum) {
  return integer_of(number(what), what, minimum, maximum);
}

std::int64_t InputLines::integer_of(double x, const std::string& what, std::int64_t minimum,
                                    std::int64_t maximum) const {
  const bool whole = x == std::floor(x) && x >= static_cast<double>(minimum) && x <= static_cast<double>(maximum);
  if (!whole)
    refuse(exact_text(x) + " is not " + what + "; allowed: an integer in [" + std::to_string(minimum) + ", " +
           std::to_string(maximum) + "]");
  return static_cast<std::int64_t>(x);
}

double InputLines::number_in(std::string text, const std::string& what) const {
  const std::string given = text;
  std::ranges::replace_if(
      text, [](char c) { return c == 'd' || c == 'D'; }, 'e'); // as Fortran writes 1.0d0
  double x = 0.0;
  const char* start = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(start, text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x))
    refuse("'" + readable(given, longest_shown) + "' is no number; needs " + what);
  return x;
}

} // namespace riedel
