#include "apps/completion.hpp"

#include "apps/biaxial/keys.hpp"
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/element/keys.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace riedel {

namespace {

using Texts = std::vector<std::string>;

/// A line of the table: a question, and the words that answer it.
std::string row(const std::string& question, const Texts& words) {
  if (words.empty()) return "";
  std::string text = "    '" + question + "') printf '%s\\n'";
  for (const std::string& word : words) text += " '" + word + "'";
  return text + " ;;\n";
}

/// What completes the placeholder of a value, DIR or FILE.csv: @dir, or @file with an ending.
Texts place_of(const std::string& value) {
  if (value == "DIR") return {"@dir"};
  const std::size_t dot = value.rfind('.');
  const bool file = value.starts_with("FILE") || value.starts_with("CASE") || value.starts_with("LIB");
  return file ? Texts{"@file" + (dot == std::string::npos ? "" : value.substr(dot))} : Texts{};
}

/// The words of `usage`, "TEST [CASE.toml] [options]", without brackets.
Texts words_of(std::string usage) {
  std::erase_if(usage, [](char c) { return c == '[' || c == ']'; });
  std::istringstream stream(usage);
  Texts words;
  for (std::string word; stream >> word;)
    if (word != "options" && word != "...") words.push_back(word);
  return words;
}

std::string rows_of(const Command& command) {
  Texts all{"--help", "--version"}, valued;
  std::string text;
  for (const Option& option : command.options) {
    all.push_back("--" + option.name);
    if (option.value.empty()) continue;
    valued.push_back("--" + option.name);
    text += row("value " + command.name + " --" + option.name,
                option.choices.empty() ? place_of(option.value) : option.choices);
    if (option.value.find(',') != std::string::npos) text += row("list " + command.name + " --" + option.name, {"yes"});
  }
  const Texts words = words_of(command.usage);
  for (std::size_t i = 0; i < words.size(); ++i)
    text += row("word " + command.name + " " + std::to_string(i + 1),
                i == 0 && !command.first_words.empty() ? command.first_words : place_of(words[i]));
  if (command.name == "list") text += row("word list more", command.first_words);
  return row("options " + command.name, all) + row("valued " + command.name, valued) + text;
}

/// Names of keys and the values of each; the parameters of laws have rows of their own.
class KeyRows {
public:
  void add(const std::string& whose, const Keys& keys) {
    Texts names;
    for (const Key& key : keys) {
      add_values(key);
      const bool of_law =
          key.name.starts_with("material.") && key.name != "material.model" && key.name != "material.plugin";
      if (!of_law || whose.starts_with("law ")) names.push_back(key.name + "=");
    }
    text_ += row(whose, names);
  }
  [[nodiscard]] std::string text() const {
    std::string all = text_;
    for (const auto& [name, words] : values_) all += row("values " + name, words);
    return all;
  }

private:
  void add_values(const Key& key) {
    Texts& words = values_[key.name];
    Texts more = std::holds_alternative<bool>(key.default_value) ? Texts{"true", "false"} : key.choices;
    if (key.name.ends_with(".plugin") || key.name == "material.library") more = {"@file.so"};
    for (const std::string& word : more)
      if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  std::string text_;
  std::map<std::string, Texts> values_;
};

std::string rows_of_keys() {
  const Catalogue catalogue = full_catalogue();
  KeyRows rows;
  for (const std::string& law : catalogue.materials.names()) {
    Keys keys = biaxial_keys(catalogue, law);
    std::erase_if(keys, [](const Key& key) { return !key.name.starts_with("material."); });
    rows.add("law " + law, keys);
  }
  rows.add("keys biaxial", biaxial_keys(catalogue, paper_model));
  for (const std::string& test : element_tests())
    rows.add("keys element " + test, element_keys(catalogue, test, paper_model));
  rows.add("keys umat-check", umat_check_keys());
  return rows.text();
}

} // namespace

const Texts& completion_shells() {
  static const Texts all{"bash", "zsh"};
  return all;
}

std::string completion(const std::string& shell, std::span<const Command> commands) {
  refuse_unknown_names("--completion", {shell}, completion_shells());
  Texts names{"help"};
  std::string rows;
  for (const Command& command : commands) {
    names.push_back(command.name);
    rows += rows_of(command);
  }
  return (shell == "zsh" ? "#compdef riedel\n" : "") + std::string("# Completion of riedel for ") + shell +
         ", made by 'riedel --completion " + shell + "'.\n\n_riedel_table() {\n  case $1 in\n" +
         row("commands", names) + row("switches", {"--help", "--version", "--man", "--completion"}) +
         row("shells", completion_shells()) + rows + rows_of_keys() + "  esac\n}\n" + std::string(completion_rules()) +
         std::string(completion_frontend(shell));
}

} // namespace riedel
