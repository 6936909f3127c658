#include "core/io/case_file.hpp"

#include "core/base/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/suggestion.hpp"

#define TOML_IMPLEMENTATION
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>

namespace riedel {

namespace {

struct Positioned {
  Given given;
  toml::source_position position;
};

std::string text_of(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  constexpr std::size_t longest = 80;
  std::string text = out.str();
  std::ranges::replace(text, '\n', ' ');
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

Scalar scalar_of(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* integer = node.as_integer()) return integer->get();
  if (const auto* real = node.as_floating_point()) return real->get();
  if (const auto* text = node.as_string()) return text->get();
  return std::monostate{};
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
    all.push_back({given_from(node, name), node.source().begin});
  }
}

/// Every value of the tree with its dotted path; the tables of an array are numbered from one.
void flatten(const toml::table& table, const std::string& prefix, std::vector<Positioned>& all) {
  for (const auto& [key, node] : table) flatten(node, prefix + std::string(key.str()), all);
}

std::optional<toml::table> parsed_table(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) { return std::nullopt; }
}

std::string position_text(const std::string& path, const toml::source_position& at) {
  return path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string unknown_key_text(const std::string& name, const Keys& keys) {
  std::vector<std::string> names;
  std::string beside; // the keys of the same section
  const std::string section = name.substr(0, name.rfind('.') + 1);
  for (const Key& key : keys) {
    names.push_back(key.name);
    if (key.name.substr(0, key.name.rfind('.') + 1) == section)
      beside += (beside.empty() ? "" : ", ") + key.name.substr(section.size());
  }
  const std::string hint = did_you_mean(name, names);
  if (!hint.empty()) return "unknown key" + hint;
  if (section.empty() || beside.empty()) return "unknown key";
  return "unknown key; [" + section.substr(0, section.size() - 1) + "] takes " + beside;
}

std::string section_text(const std::string& name, const Keys& keys) {
  std::string inside;
  for (const Key& key : keys)
    if (key.name.starts_with(name + ".")) inside += (inside.empty() ? "" : ", ") + key.name;
  return "is a section, not a key; its keys are " + inside;
}

bool is_section(const std::string& name, const Keys& keys) {
  return std::ranges::any_of(keys, [&](const Key& key) { return key.name.starts_with(name + "."); });
}

} // namespace

CaseFile CaseFile::read(const std::filesystem::path& path) {
  const std::string text = read_input_file(path);
  std::vector<Positioned> all;
  try {
    flatten(toml::parse(text, path.string()), "", all);
  } catch (const toml::parse_error& error) {
    throw InputError(position_text(path.string(), error.source().begin) +
                     ": not valid TOML: " + std::string(error.description()));
  }
  std::ranges::sort(all, {}, [](const Positioned& p) { return std::pair(p.position.line, p.position.column); });
  CaseFile file;
  for (Positioned& p : all) {
    p.given.place = position_text(path.string(), p.position) + ": " + p.given.name;
    file.given_.push_back(std::move(p.given));
  }
  return file;
}

void CaseFile::override_with(std::string_view assignment, const std::string& source) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw InputError("--set " + std::string(assignment) + ": expected KEY=VALUE, such as specimen.width=0.05");
  const std::string key(assignment.substr(0, equals));
  std::vector<Positioned> all;
  if (const auto parsed = parsed_table(assignment)) {
    flatten(*parsed, "", all);
  } else if (const auto named = parsed_table(key + "=''")) { // a bare word, or a text whose quotes the shell has eaten
    flatten(*named, "", all);
    const std::string value(assignment.substr(equals + 1));
    all.front().given.items = {value};
    all.front().given.text = "\"" + value + "\"";
  } else {
    throw InputError("--set " + std::string(assignment) + ": '" + key + "' is not the name of a key");
  }
  for (Positioned& p : all) {
    p.given.place = source + " " + p.given.name;
    std::erase_if(given_, [&](const Given& old) { return old.name == p.given.name; });
    given_.push_back(std::move(p.given));
  }
}

const Given* CaseFile::find(std::string_view key) const {
  const auto found = std::ranges::find(given_, key, &Given::name);
  return found == given_.end() ? nullptr : &*found;
}

std::optional<std::string> CaseFile::peek_text(std::string_view key) const {
  const Given* given = find(key);
  if (given == nullptr || given->kind != Given::Kind::single) return std::nullopt;
  const auto* text = std::get_if<std::string>(&given->items.front());
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::optional<std::vector<std::string>> CaseFile::peek_texts(std::string_view key) const {
  const Given* given = find(key);
  if (given == nullptr) return std::nullopt;
  std::vector<std::string> texts;
  for (const Scalar& item : given->items)
    if (const auto* text = std::get_if<std::string>(&item)) texts.push_back(*text);
  if (given->kind != Given::Kind::list || texts.size() != given->items.size())
    throw InputError(given->place + ": is " + given->text + "; allowed: a list of texts, such as [\"a\", \"b\"]");
  return texts;
}

std::vector<std::string> CaseFile::names_in(std::string_view section) const {
  std::vector<std::string> names;
  for (const Given& given : given_)
    if (given.name.starts_with(std::string(section) + ".")) names.push_back(given.name);
  return names;
}

CaseFile CaseFile::without(std::string_view section) const {
  CaseFile rest = *this;
  std::erase_if(rest.given_, [&](const Given& given) {
    return given.name == section || given.name.starts_with(std::string(section) + ".");
  });
  return rest;
}

int CaseFile::count(std::string_view list) const {
  std::set<int> numbers;
  for (const Given& given : given_) {
    if (!given.name.starts_with(std::string(list) + ".")) continue;
    int number = 0;
    const std::string_view rest = std::string_view(given.name).substr(list.size() + 1);
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
    numbers.insert(number);
  }
  int last = 0;
  while (numbers.contains(last + 1)) ++last;
  return last;
}

std::string CaseFile::place(std::string_view key) const {
  const Given* given = find(key);
  return given == nullptr ? std::string(key) + " (default)" : given->place;
}

CheckedValues CaseFile::check(const Keys& keys) const {
  CheckedValues checked{.values = Values(keys), .errors = {}};
  for (const Given& given : given_) {
    const auto key = std::ranges::find(keys, given.name, &Key::name);
    try {
      if (key != keys.end())
        checked.values.set(key->name, convert(given, *key));
      else if (!is_section(given.name, keys))
        throw InputError(unknown_key_text(given.name, keys));
      else if (given.kind != Given::Kind::empty_section)
        throw InputError(section_text(given.name, keys));
    } catch (const InputError& error) { checked.errors.push_back({{given.name}, error.what()}); }
  }
  return checked;
}

Values CaseFile::validate(const Keys& keys) const {
  CheckedValues checked = check(keys);
  if (!checked.errors.empty()) throw InputError(lines(checked.errors));
  return std::move(checked.values);
}

std::string CaseFile::lines(const std::vector<Finding>& findings) const {
  std::string text;
  for (const Finding& finding : findings)
    text += (text.empty() ? "" : "\n") + place(finding.keys.front()) + ": " + finding.text;
  return text;
}

} // namespace riedel
