#include "core/base/suggestion.hpp"

#include <algorithm>
#include <vector>

namespace riedel {

namespace {
std::string_view last_part(std::string_view word) { return word.substr(word.rfind('.') + 1); } // npos + 1 is 0
} // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> before(width), above(width), row(width); // rows i − 2, i − 1 and i of the table
  for (std::size_t j = 0; j < width; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < width; ++j) {
      const int replaced = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above.back();
}

namespace {

constexpr int far = 1000;
constexpr std::size_t longest_word = 100; ///< anything longer is not a mistyped word

/// Distance for words with typing errors, cut short, or with another section in front.
int distance_meant(std::string_view word, std::string_view known) {
  const bool cut_short = word.size() >= 3 && known.starts_with(word);
  const bool has_section = known.find('.') != std::string_view::npos;
  return std::min({edit_distance(word, known), cut_short ? 1 : far,
                   has_section ? edit_distance(last_part(word), last_part(known)) + 1 : far});
}

} // namespace

std::string nearest(std::string_view word, std::span<const std::string> known) {
  if (word.size() > longest_word) return "";
  const int size = static_cast<int>(last_part(word).size());
  const int maximum = std::min(std::max(1, size / 3), size - 1); // every other digit is one letter away from "6"
  int best = maximum + 1;
  std::string answer;
  for (const std::string& candidate : known) {
    const int distance = distance_meant(word, candidate);
    if (distance < best && distance < static_cast<int>(word.size())) { // otherwise no letter is kept
      best = distance;
      answer = candidate;
    }
  }
  return answer;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::string near = nearest(word, known);
  return near.empty() ? near : " (did you mean '" + near + "'?)";
}

} // namespace riedel
