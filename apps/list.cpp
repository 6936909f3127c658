/// riedel list: what can be named in a case.
#include "apps/biaxial/keys.hpp"
#include "apps/built_in.hpp"
#include "apps/commands.hpp"
#include "apps/entry_text.hpp"
#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/case/key_tables.hpp"

#include <algorithm>
#include <functional>
#include <iostream>

namespace riedel {

namespace {

using Texts = std::vector<std::string>;

/// One thing that can be named: a line or more in a group's list, and its full text.
struct Entry {
  std::string name, brief;
  std::function<std::string()> whole;
};

struct Group {
  std::string name; ///< "schemes"
  std::vector<Entry> entries;
  std::string if_empty;
};

/// @param whole makes the full text of a single entry
template <class Make, class Whole>
Group group(const std::string& name, const Registry<Make>& registry, const Whole& whole) {
  Group all{name, {}, ""};
  for (const auto& entry : registry.entries())
    all.entries.push_back({entry.description.name, brief_text(entry.description), [=] { return whole(entry); }});
  return all;
}

Group group_of(const std::vector<LoadedPlugin>& plugins) {
  Group all{"plugins", {}, "  none; RIEDEL_PLUGIN_PATH names folders to search\n"};
  for (const LoadedPlugin& plugin : plugins) {
    std::string text = "  " + plugin.path.string() + ", compiled by g++ " + plugin.compiler + "\n";
    for (const std::string& entry : plugin.brings) text += "    " + entry + "\n";
    all.entries.push_back({plugin.path.filename().string(), text, [=] { return "plug-in\n" + text; }});
  }
  return all;
}

std::vector<Group> groups_of(const Inventory& load_catalogue) {
  const Catalogue& all = load_catalogue.catalogue;
  const auto keyed = [](std::string kind, std::string key) {
    return [=](const auto& entry) { return entry_text(entry.description, kind, key); };
  };
  const auto of_boundary = [](const auto& entry) { return boundary_text(entry.description); };
  const auto of_scheme = [&all](const auto& entry) { return scheme_text(entry.description, all); };
  return {group("schemes", all.in_2d.schemes, of_scheme),
          group("materials", all.materials, law_text),
          group("searches", all.in_2d.searches, keyed("search for neighbours", "nonlocal.search")),
          group("averagers", all.in_2d.averagers, keyed("averager", "nonlocal.averager")),
          group("boundaries", all.in_2d.boundaries, of_boundary),
          group("transfers", all.in_2d.transfers, keyed("transfer of velocities", "time.transfer")),
          group_of(load_catalogue.plugins)};
}

std::string text_of(const Group& group) {
  std::string text = group.name + "\n";
  for (const Entry& entry : group.entries) text += entry.brief;
  return group.entries.empty() ? text + group.if_empty : text;
}

/// The text about a key, or about a word that keys can take.
std::string key_text(const std::string& wish, const Catalogue& catalogue) {
  std::string text;
  for (const Key& key : biaxial_keys(catalogue, ""))
    if (key.name == wish || std::ranges::find(key.choices, wish) != key.choices.end())
      text += (key.name == wish ? "key\n" : "\"" + wish + "\" is a value of the key\n") + parameters_help({key});
  return text;
}

/// Everything that a word stands for; some words name two things. @throws InputError for an unknown word
std::string text_of(const std::string& wish, const std::vector<Group>& groups, const Catalogue& catalogue) {
  Texts texts, names, known;
  for (const Group& group : groups) {
    known.push_back(group.name);
    if (group.name == wish) texts.push_back(text_of(group));
  }
  for (const Group& group : groups)
    for (const Entry& entry : group.entries) {
      names.push_back(entry.name);
      if (entry.name == wish) texts.push_back(entry.whole());
    }
  if (texts.empty()) texts.push_back(key_text(wish, catalogue));
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "\n") + text;
  if (!all.empty()) return all;
  names.insert(names.begin(), known.begin(), known.end());
  for (const Key& key : biaxial_keys(catalogue, "")) names.push_back(key.name);
  std::string list;
  for (const std::string& each : known) list += each + ", ";
  throw InputError("nothing to list is called '" + wish + "'" + did_you_mean(wish, names) + "; known: " + list +
                   "a name in one of them, or a key of a case");
}

} // namespace

std::vector<std::string> list_words() {
  const Catalogue all = full_catalogue();
  Texts words{"schemes", "materials", "searches", "averagers", "boundaries", "transfers", "plugins"};
  for (const Texts& names : {all.in_2d.schemes.names(), all.materials.names(), all.in_2d.searches.names(),
                             all.in_2d.averagers.names(), all.in_2d.boundaries.names(), all.in_2d.transfers.names()})
    words.insert(words.end(), names.begin(), names.end());
  return words;
}

namespace {

int list(const Arguments& arguments) {
  const Inventory all = load_catalogue(arguments.list("plugin", {}));
  const std::vector<Group> groups = groups_of(all);
  std::string text;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "\n") + more; };
  for (const std::string& wish : arguments.words) add(text_of(wish, groups, all.catalogue));
  if (arguments.words.empty())
    for (const Group& group : groups) add(text_of(group));
  std::cout << text;
  return 0;
}

std::string list_help(const Arguments&) {
  return R"(A single name is shown in full: what it is, its source, its parameters with unit, default and range, and
for a law its state variables and the variables that it can take averaged.

Examples
  riedel list schemes
  riedel list mohr_coulomb
  riedel list nonlocal.length
  riedel list --plugin build/wu_bauer.so wu_bauer
)";
}

} // namespace

Command list_command() {
  return {.name = "list",
          .usage = "[schemes|materials|searches|averagers|boundaries|transfers|plugins|NAME ...] [options]",
          .summary =
              "Lists what a case can name: everything, a group, or one scheme, law, search, averager, transfer or "
              "key in full.",
          .max_words = 100,
          .options = {plugin_option()},
          .run = list,
          .more_help = list_help,
          .first_words = list_words()};
}

} // namespace riedel
