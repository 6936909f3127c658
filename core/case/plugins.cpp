#include "core/case/plugins.hpp"

#include "core/base/error.hpp"

#include <cstdlib>
#include <sstream>

namespace riedel {

namespace {

namespace fs = std::filesystem;

/// The folders in RIEDEL_PLUGIN_PATH, separated by colons.
std::vector<fs::path> plugin_folders() {
  std::vector<fs::path> folders;
  const char* const path = std::getenv("RIEDEL_PLUGIN_PATH");
  std::istringstream stream(path == nullptr ? "" : path);
  for (std::string folder; std::getline(stream, folder, ':');)
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

/// Sorted by name, so that the catalogue is the same everywhere.
std::vector<fs::path> libraries_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".so") found.push_back(entry.path());
  if (error) throw PluginError("RIEDEL_PLUGIN_PATH: " + folder.string() + ": " + error.message());
  std::ranges::sort(found);
  return found;
}

fs::path found_in_folders(const std::string& name) {
  const fs::path path(name);
  if (path.has_parent_path() || fs::exists(path)) return path;
  for (const fs::path& folder : plugin_folders())
    if (fs::exists(folder / path)) return folder / path;
  return path;
}

/// A library that is named twice adds its entries once.
void add(Inventory& all, const fs::path& path) {
  std::error_code error;
  for (const LoadedPlugin& loaded : all.plugins)
    if (fs::equivalent(loaded.path, path, error)) return;
  all.plugins.push_back(load_plugin(path, all.catalogue));
}

} // namespace

Inventory with_plugins(Catalogue built_in, const std::vector<std::string>& named) {
  Inventory all{.catalogue = std::move(built_in), .plugins = {}};
  for (const fs::path& folder : plugin_folders())
    for (const fs::path& path : libraries_in(folder)) add(all, path);
  for (const std::string& name : named) add(all, found_in_folders(name));
  return all;
}

Inventory with_plugins(Catalogue built_in, const CaseFile& given) {
  Inventory all = with_plugins(std::move(built_in), std::vector<std::string>{});
  for (const std::string key : {"material.plugin", "interpolation.plugin", "nonlocal.plugin", "time.plugin"}) {
    const std::string name = given.peek_text(key).value_or("");
    if (name.empty()) continue;
    try {
      add(all, found_in_folders(name));
    } catch (const PluginError& error) { throw PluginError(given.place(key) + ": " + error.what()); }
  }
  return all;
}

} // namespace riedel
