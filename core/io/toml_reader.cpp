#include "core/io/toml_reader.hpp"

#include "core/io/case_text.hpp"
#include "core/io/readable.hpp"
#include "core/io/toml_words.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

// What toml++ takes for granted of its input must hold or throw: as plain assertions it would end the program, and as
// promises to the compiler, which they are with NDEBUG, it would do anything.
#undef NDEBUG
namespace riedel {
struct BrokenPromise : std::logic_error {
  using std::logic_error::logic_error;
};
constexpr void promised(bool holds, const char* what) {
  if (!holds) throw BrokenPromise(what);
}
} // namespace riedel
#define TOML_ASSERT(holds) ::riedel::promised(static_cast<bool>(holds), #holds)
#define TOML_MAX_NESTED_VALUES 16 // a case has lists and tables in lists; recursion must end before the stack does
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>

namespace riedel {

namespace {

constexpr std::size_t largest_case = 4 << 20; ///< [bytes]; it is written by hand or by this program
constexpr std::size_t most_parts = 64;        ///< of a dotted name: each is a table in a table, and so a call in a call

constexpr std::size_t longest_name = 200; ///< in messages [bytes]
constexpr std::size_t longest_text = 80;  ///< in messages [bytes]

struct Position {
  std::size_t line = 1, column = 1; ///< columns count characters
};

struct Positioned {
  Given given;
  Position at;
};

Scalar scalar_of(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* integer = node.as_integer()) return integer->get();
  if (const auto* real = node.as_floating_point()) return real->get();
  if (const auto* text = node.as_string()) return text->get();
  return std::monostate{};
}

std::string scalar_text(const toml::node& node) {
  std::ostringstream out;
  if (const auto* date = node.as_date()) out << *date;
  if (const auto* time = node.as_time()) out << *time;
  if (const auto* both = node.as_date_time()) out << *both;
  const auto as_toml = [](const auto& value) -> std::string {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
      return "";
    else
      return toml_text(value);
  };
  return out.str() + std::visit(as_toml, scalar_of(node));
}

/// For messages, so that no more is written than one of them shows.
void append_text(const toml::node& node, std::string& text) {
  if (text.size() > longest_text) return;
  const toml::array* list = node.as_array();
  const toml::table* table = node.as_table();
  if (list == nullptr && table == nullptr) text += scalar_text(node);
  if (list != nullptr) {
    text += "[";
    for (auto item = list->begin(); item != list->end() && text.size() <= longest_text; ++item) {
      if (item != list->begin()) text += ", ";
      append_text(*item, text);
    }
    text += "]";
  }
  if (table != nullptr) text += table->empty() ? "{}" : "{...}";
}

std::string text_of(const toml::node& node) {
  std::string text;
  append_text(node, text);
  return readable(text, longest_text);
}

Given given_from(const toml::node& node, const std::string& name) {
  Given given{.name = name, .place = "", .text = text_of(node), .items = {}};
  if (const toml::array* list = node.as_array()) {
    given.kind = Given::Kind::list;
    for (const toml::node& item : *list) given.items.push_back(scalar_of(item));
  } else if (node.is_table()) {
    given.kind = Given::Kind::empty_section;
  } else {
    given.items.push_back(scalar_of(node));
  }
  return given;
}

void flatten(const toml::table& table, const std::string& prefix, std::vector<Positioned>& all);

void flatten(const toml::node& node, const std::string& name, std::vector<Positioned>& all) {
  const toml::table* inner = node.as_table();
  const toml::array* list = node.as_array();
  if (inner != nullptr && !inner->empty()) {
    flatten(*inner, name + ".", all);
  } else if (list != nullptr && list->is_array_of_tables()) {
    int number = 0;
    for (const toml::node& item : *list) flatten(item, name + "." + std::to_string(++number), all);
  } else {
    all.push_back({given_from(node, name), {node.source().begin.line, node.source().begin.column}});
  }
}

void flatten(const toml::table& table, const std::string& prefix, std::vector<Positioned>& all) {
  for (const auto& [key, node] : table) {
    const std::string word(key.str());
    flatten(node, prefix + (is_bare_word(word) ? word : toml_text(word)), all);
  }
}

Position position_in(std::string_view text, std::size_t byte) {
  Position at;
  for (const char c : text.substr(0, byte)) {
    if (c == '\n') at = {at.line + 1, 0};
    if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) ++at.column; // a byte that begins a character
  }
  return at;
}

std::string place_of(const std::string& called, Position at) {
  return called + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
}

[[noreturn]] void refuse(const std::string& called, Position at, const std::string& why) {
  throw TomlError(place_of(called, at) + "not valid TOML: " + why, why);
}

/// Where a name has more parts than any key, if anywhere: dots with no sign between them that could end a name.
/// @param signs of the text, without what stands in quotes and comments
std::optional<std::size_t> endless_name(std::string_view signs) {
  std::size_t dots = 0;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const char c = signs[i];
    if (std::string_view("\n,=[]{}#").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > most_parts) return i;
  }
  return std::nullopt;
}

/// toml++ takes for granted that letters beyond ASCII stand in texts and comments.
void refuse_odd_signs(std::string_view text, const std::string& called) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::size_t start = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  const std::string signs = without_texts(text);
  for (std::size_t i = start; i < signs.size(); ++i)
    if (static_cast<unsigned char>(signs[i]) >= 0x80)
      refuse(called, position_in(text, i), "a letter beyond ASCII, which stands in quotes only");
  if (const auto at = endless_name(signs))
    refuse(called, position_in(text, *at),
           "a name with more than " + std::to_string(most_parts) + " dots, which no key has");
}

void refuse_what_is_no_text(std::string_view text, const std::string& called) {
  if (text.size() > largest_case)
    throw InputError(called + ": is larger than " + std::to_string(largest_case >> 20u) + " MiB: not a case file");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(called + ": is written in UTF-16; save it as UTF-8");
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    refuse(called, position_in(text, zero), "a byte that is zero, which no text has");
  if (const std::size_t valid = valid_utf8(text); valid < text.size())
    refuse(called, position_in(text, valid), "a byte that is no UTF-8; save the file as UTF-8");
  refuse_odd_signs(text, called);
}

/// The fewest bytes of a text whose parser trips over a promise that they break.
std::size_t bytes_that_break(std::string_view text) {
  std::size_t fine = 0, broken = text.size();
  while (broken - fine > 1) {
    const std::size_t middle = fine + (broken - fine) / 2;
    try {
      (void)toml::parse(text.substr(0, middle));
      fine = middle;
    } catch (const toml::parse_error&) { fine = middle; } catch (const BrokenPromise&) {
      broken = middle;
    }
  }
  return broken;
}

std::string_view line_of(std::string_view text, std::size_t line) {
  for (std::size_t i = 1; i < line && !text.empty(); ++i)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

toml::table parsed(std::string_view text, const std::string& called) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const Position at{error.source().begin.line, error.source().begin.column};
    refuse(called, at, readable(error.description()) + toml_hint(line_of(text, at.line)));
  } catch (const BrokenPromise&) {
    const Position at = position_in(text, bytes_that_break(text) - 1);
    refuse(called, at, "'" + readable(line_of(text, at.line), 80) + "' cannot be understood");
  }
}

} // namespace

std::vector<Given> read_toml(std::string_view text, const std::string& called) {
  refuse_what_is_no_text(text, called);
  std::vector<Positioned> all;
  flatten(parsed(text, called), "", all);
  std::ranges::stable_sort(all, {}, [](const Positioned& p) { return std::pair(p.at.line, p.at.column); });
  std::vector<Given> given;
  for (Positioned& p : all) {
    p.given.place = place_of(called, p.at) + readable(p.given.name, longest_name);
    given.push_back(std::move(p.given));
  }
  return given;
}

} // namespace riedel
