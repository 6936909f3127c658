#include "core/case/case_file.hpp"

#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/case/toml_reader.hpp"
#include "core/io/input_file.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <unordered_map>

namespace riedel {

namespace {

constexpr std::size_t max_errors = 100; ///< reported at once

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

CaseFile CaseFile::read(const std::filesystem::path& path) { return from_text(read_input_file(path), path.string()); }

CaseFile CaseFile::from_text(std::string_view text, const std::string& called) {
  CaseFile file;
  file.given_ = read_toml(text, called);
  for (const RawEntry& given : file.given_) file.names_.insert(given.name);
  return file;
}

void CaseFile::override_with(std::string_view assignment, const std::string& source) {
  for (RawEntry& given : read_assignment(assignment, source)) {
    if (!names_.insert(given.name).second)
      std::erase_if(given_, [&](const RawEntry& old) { return old.name == given.name; });
    given_.push_back(std::move(given));
  }
}

const RawEntry* CaseFile::find(std::string_view key) const {
  const auto found = std::ranges::find(given_, key, &RawEntry::name);
  return found == given_.end() ? nullptr : &*found;
}

std::optional<std::string> CaseFile::peek_text(std::string_view key) const {
  const RawEntry* given = find(key);
  if (given == nullptr || given->kind != RawEntry::Kind::single) return std::nullopt;
  const auto* text = std::get_if<std::string>(&given->items.front());
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::optional<std::vector<std::string>> CaseFile::peek_texts(std::string_view key) const {
  const RawEntry* given = find(key);
  if (given == nullptr) return std::nullopt;
  std::vector<std::string> texts;
  for (const Scalar& item : given->items)
    if (const auto* text = std::get_if<std::string>(&item)) texts.push_back(*text);
  if (given->kind != RawEntry::Kind::list || texts.size() != given->items.size())
    throw InputError(given->place + ": is " + given->text + "; allowed: a list of texts, such as [\"a\", \"b\"]");
  return texts;
}

std::vector<std::string> CaseFile::names_in(std::string_view section) const {
  std::vector<std::string> names;
  for (const RawEntry& given : given_)
    if (given.name.starts_with(std::string(section) + ".")) names.push_back(given.name);
  return names;
}

CaseFile CaseFile::without(std::string_view section) const {
  CaseFile rest = *this;
  std::erase_if(rest.given_, [&](const RawEntry& given) {
    return given.name == section || given.name.starts_with(std::string(section) + ".");
  });
  return rest;
}

int CaseFile::count(std::string_view list) const {
  std::set<std::string_view> numbers;
  for (const RawEntry& given : given_) {
    if (!given.name.starts_with(std::string(list) + ".")) continue;
    const std::string_view rest = std::string_view(given.name).substr(list.size() + 1);
    numbers.insert(rest.substr(0, rest.find('.')));
  }
  int last = 0;
  while (numbers.contains(std::to_string(last + 1))) ++last;
  return last;
}

std::string CaseFile::place(std::string_view key) const {
  const RawEntry* given = find(key);
  return given == nullptr ? std::string(key) + " (default)" : given->place;
}

CheckedValues CaseFile::check(const Keys& keys) const {
  CheckedValues checked{.values = Values(keys), .errors = {}};
  std::unordered_map<std::string_view, const Key*> known;
  for (const Key& key : keys) known.emplace(key.name, &key);
  for (const RawEntry& given : given_) {
    if (checked.errors.size() == max_errors) {
      checked.errors.push_back({{given.name}, "possibly more errors, which are not shown"});
      break;
    }
    const auto key = known.find(given.name);
    try {
      if (key != known.end())
        checked.values.set(given.name, convert(given, *key->second));
      else if (!is_section(given.name, keys))
        throw InputError(unknown_key_text(given.name, keys));
      else if (given.kind != RawEntry::Kind::empty_section)
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
