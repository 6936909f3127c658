#include "architecture/rules.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace riedel::architecture {

namespace {

using Names = std::set<std::string>;

/// Calls `visit(line, number)` for every line.
template <class Visit>
void for_each_line(const std::string& text, const Visit& visit) {
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) visit(line, ++number);
}

std::string place(const SourceFile& file, int line) { return file.path + ":" + std::to_string(line) + ": "; }

/// An offence for every line in which the pattern is found.
Offences lines_with(const SourceFile& file, const std::regex& pattern, const std::string& complaint) {
  Offences found;
  for_each_line(file.text, [&](const std::string& line, int number) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) found.push_back(place(file, number) + complaint + ": " + match.str());
  });
  return found;
}

/// Calls `visit(name, line number)` for `#include "name"` or, when opening is '<', for `#include <name>`.
template <class Visit>
void for_each_include(const std::string& text, char opening, const Visit& visit) {
  const std::regex pattern(opening == '<' ? R"(^\s*#\s*include\s*<([^>]+)>)" : R"(^\s*#\s*include\s*"([^"]+)\")");
  for_each_line(text, [&](const std::string& line, int number) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) visit(match.str(1), number);
  });
}

/// The floors of core up to and including one.
Names up_to(std::string_view top) {
  Names all;
  for (const char* floor : {"base", "state", "interface", "step", "setup", "io", "draw", "case", "analysis", "run"}) {
    all.insert(std::string("core/") + floor);
    if (top == std::string("core/") + floor) break;
  }
  return all;
}

/// What each room may include of the others; apps and tests, which may include everything, are not listed. A folder
/// that is not listed belongs to the room above it.
const std::map<std::string, Names>& rooms_in_sight() {
  static const std::map<std::string, Names> sight = {
      {"core/base", {}},
      {"core/state", {"core/base"}},
      {"core/interface", {"core/base", "core/state"}},
      {"core/step", {"core/base", "core/state", "core/interface"}},
      {"core/setup", up_to("core/step")},
      {"core/io", up_to("core/step")},
      {"core/draw", up_to("core/io")},
      {"core/case", up_to("core/io")},
      {"core/analysis", up_to("core/io")},
      {"core/run", up_to("core/draw")},
      {"core/campaign", up_to("core/run")},
      {"shapefunctions/kit", {"core/base", "core/state", "core/interface"}},
      {"shapefunctions", {"core/base", "core/state", "core/interface", "shapefunctions/kit"}},
      {"transfers/kit", {"core/base", "core/state", "core/interface", "core/step"}},
      {"transfers", {"core/base", "core/state", "core/interface", "core/step", "transfers/kit"}},
      {"materials/kit", {"core/base", "core/interface"}},
      {"materials/umat", {"core/base", "core/interface"}},
      {"materials", {"core/base", "core/interface", "materials/kit", "materials/umat"}},
      {"materials/element", {"core/base", "core/interface", "materials", "materials/kit", "materials/umat"}},
      {"nonlocal/kit", {"core/base", "core/interface"}},
      {"nonlocal", {"core/base", "core/interface", "nonlocal/kit"}},
  };
  return sight;
}

/// The room that a path lies in: "core/base", "materials/kit", "tests", ...; in core every folder is one, known or not.
std::string room_of(const std::string& path) {
  std::string folder = path.substr(0, path.find_last_of('/'));
  const std::size_t depth = path.starts_with("core/") ? 1 : 0;
  while (static_cast<std::size_t>(std::ranges::count(folder, '/')) > depth && !rooms_in_sight().contains(folder))
    folder.resize(folder.find_last_of('/'));
  return path.find('/') == std::string::npos ? "" : folder;
}

struct Library {
  std::string name;
  std::regex header;
  std::regex home; ///< files that may include it
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> all = {
      {"CGAL", std::regex("^CGAL/"), std::regex("nonlocal/cgal_kd_tree[.]cpp")},
      {"VTK", std::regex("^vtk"), std::regex("core/(io/vtk_writer|draw/[a-z_]+)[.]cpp")},
      {"toml++", std::regex("^toml([+][+])?[/.]"), std::regex("core/case/toml_reader[.]cpp")},
      {"Boost", std::regex("^boost/"), std::regex("apps/[^/]*[.]cpp|core/io/plugin_loader[.]cpp")},
  };
  return all;
}

/// The file's name without folders and ending.
std::string stem(const std::string& path) {
  const std::size_t start = path.rfind('/') + 1;
  return path.substr(start, path.rfind('.') - start);
}

/// `snake_case` and `CamelCase` taken apart, so that a name is found as a word inside a longer one.
std::string split_words(const std::string& text) {
  const std::string apart = std::regex_replace(text, std::regex("([a-z0-9])([A-Z])"), "$1 $2");
  return std::regex_replace(apart, std::regex("_"), " ");
}

} // namespace

Offences includes_that_run_up(const SourceFile& file) {
  const std::string room = room_of(file.path);
  if (room == "apps" || room == "tests") return {};
  const auto sight = rooms_in_sight().find(room);
  if (sight == rooms_in_sight().end()) return {file.path + ": lies in no known room"};
  Offences found;
  for_each_include(file.text, '"', [&](const std::string& name, int line) {
    const std::string target = room_of(name);
    if (target != room && !sight->second.contains(target))
      found.push_back(place(file, line) + room + " must not include \"" + name + "\"");
  });
  return found;
}

Offences includes_of_other_apps(const SourceFile& file) {
  static const std::regex folder("^apps/([^/]+)/.+");
  std::smatch own, other;
  if (!std::regex_match(file.path, own, folder)) return {};
  Offences found;
  for_each_include(file.text, '"', [&](const std::string& name, int line) {
    if (std::regex_match(name, other, folder) && other.str(1) != own.str(1))
      found.push_back(place(file, line) + "must not include another app's \"" + name +
                      "\"; core or apps/*.hpp may stand between");
  });
  return found;
}

Offences circles_of_includes(const std::vector<SourceFile>& files) {
  std::map<std::string, Names> includes;
  for (const SourceFile& file : files)
    for_each_include(file.text, '"', [&](const std::string& name, int) { includes[file.path].insert(name); });
  // Files that include none of those left, or that none of those left includes, are removed until nothing changes; what
  // remains are circles and the paths from one to another.
  const auto includes_nothing = [&](const auto& entry) {
    return std::ranges::none_of(entry.second, [&](const std::string& name) { return includes.contains(name); });
  };
  const auto is_included_by_nothing = [&](const auto& entry) {
    return std::ranges::none_of(includes, [&](const auto& other) { return other.second.contains(entry.first); });
  };
  while (std::erase_if(includes, includes_nothing) + std::erase_if(includes, is_included_by_nothing) > 0) {}
  Offences found;
  for (const auto& [path, names] : includes) found.push_back(path + ": is part of a circle of includes");
  return found;
}

Offences libraries_out_of_place(const SourceFile& file) {
  if (room_of(file.path) == "tests") return {};
  Offences found;
  for_each_include(file.text, '<', [&](const std::string& name, int line) {
    for (const Library& library : libraries())
      if (std::regex_search(name, library.header) && !std::regex_match(file.path, library.home))
        found.push_back(place(file, line) + library.name + " does not belong here: <" + name + ">");
  });
  return found;
}

std::vector<std::string> names_of_plugged_in(const std::vector<SourceFile>& files) {
  const Names everyday = {"linear", "elastic", "strain", "von", "coulomb", "flip"};
  Names names;
  for (const SourceFile& file : files) {
    const std::string room = room_of(file.path), name = stem(file.path);
    if ((room != "shapefunctions" && room != "materials" && room != "transfers") || name == "register") continue;
    bool distinct = false;
    std::istringstream words(split_words(name));
    for (std::string word; words >> word;) {
      if (everyday.contains(word)) continue;
      names.insert(word);
      distinct = true;
    }
    if (!distinct) names.insert('"' + name + '"');
  }
  return {names.begin(), names.end()};
}

Offences names_in_core(const SourceFile& file, const std::vector<std::string>& names) {
  if (!file.path.starts_with("core/")) return {};
  Offences found;
  for (const std::string& name : names) {
    const bool quoted = name.starts_with('"');
    const std::regex pattern(quoted ? name : "\\b" + name + "\\b", std::regex::icase);
    const SourceFile searched = quoted ? file : SourceFile{file.path, split_words(file.text)};
    const Offences more = lines_with(searched, pattern, "core names a scheme, law or transfer");
    found.insert(found.end(), more.begin(), more.end());
  }
  return found;
}

Offences kinds_of_boundaries_known(const SourceFile& file, const std::vector<SourceFile>& files) {
  Offences found;
  for (const SourceFile& kind : files) {
    const std::string room = "core/step/boundaries/", name = room + stem(kind.path);
    if (kind.path != name + ".hpp" || kind.text.find("std::string_view kind = ") == std::string::npos) continue;
    const bool own = file.path == name + ".cpp" || file.path == room + "register.cpp";
    if (own || !file.path.starts_with("core/") || file.path.starts_with("core/setup/")) continue;
    for_each_include(file.text, '"', [&](const std::string& included, int line) {
      if (included == kind.path) found.push_back(place(file, line) + "knows a kind of boundary condition: " + included);
    });
  }
  return found;
}

Offences files_too_long(const SourceFile& file) {
  const auto lines = std::ranges::count(file.text, '\n');
  const int allowed = file.path.ends_with(".cpp") ? 280 : 140;
  if (lines <= allowed) return {};
  return {file.path + ": " + std::to_string(lines) + " lines, of " + std::to_string(allowed) + " allowed"};
}

Offences unfinished_work(const SourceFile& file) {
  static const std::regex pattern(R"(\b(T[O]DO|F[I]XME|X{3}|H[A]CK)\b)"); // spelled so that it does not find itself
  return lines_with(file, pattern, "unfinished work");
}

Offences paths_of_a_machine(const SourceFile& file) {
  static const std::regex pattern(R"((^|[^\w.>)\]}/])/(home|root|Users|work|tmp|mnt|opt)/)");
  return lines_with(file, pattern, "a path of one machine");
}

} // namespace riedel::architecture
