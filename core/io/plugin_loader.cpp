#include "core/io/plugin_loader.hpp"

#include "core/base/undisturbed.hpp"
#include "core/interface/plugin.hpp"
#include "core/io/attempt.hpp"

#include <boost/dll/shared_library.hpp>
#include <dlfcn.h>

namespace riedel {

namespace {

using Library = boost::dll::shared_library;

/// Bound now, so that a missing symbol is reported here; local symbols; never unloaded.
const auto mode = boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local |
                  static_cast<boost::dll::load_mode::type>(RTLD_NODELETE);

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw PluginError("plug-in " + path.string() + ": " + why);
}

Library opened(const std::filesystem::path& path) {
  Library library;
  try {
    library.load(path.string(), mode);
  } catch (const std::exception& error) {
    const std::string text = error.what();
    const std::size_t colon = text.find(": ");
    refuse(path, "cannot be loaded: " + (colon == std::string::npos ? text : text.substr(colon + 2)));
  }
  return library;
}

std::string this_version() { return RIEDEL_VERSION; }

std::string series(const std::string& version) { return version.substr(0, version.rfind('.')); }

/// g++ gives only its version number.
std::string compiler_named(const std::string& version) {
  return (version.find("lang") == std::string::npos ? "g++ " : "") + version;
}

/// The exported object, if both sides are compatible.
const Plugin& checked(const Library& library, const std::filesystem::path& path) {
  const char* const symbol = "riedel_plugin";
  if (!library.has(symbol))
    refuse(path, "is not a plug-in for Riedel: it exports no 'riedel_plugin' (see RIEDEL_PLUGIN)");
  const Plugin own, &plugin = library.get<const Plugin>(symbol);
  if (plugin.magic != own.magic) refuse(path, "is not a plug-in for Riedel: its 'riedel_plugin' is something else");
  const std::string mend = "; compile it against the headers of this program";
  if (plugin.abi != own.abi)
    refuse(path, "has the binary interface " + std::to_string(plugin.abi) + ", and this program has " +
                     std::to_string(own.abi) + mend);
  if (series(plugin.version) != series(own.version))
    refuse(path, "was compiled for Riedel " + std::string(plugin.version) + ", and this is " + this_version() + mend);
  if (plugin.sizes != own.sizes)
    refuse(path, "was compiled by " + compiler_named(plugin.compiler) + ", this program by " +
                     compiler_named(own.compiler) + ", and they lay out types differently" + mend +
                     ", with its compiler and options");
  return plugin;
}

/// Makes objects as the plug-in does, after checking that this does not crash.
template <class Object, class... Args>
std::function<std::unique_ptr<Object>(Args...)> guarded(std::function<std::unique_ptr<Object>(Args...)> make,
                                                        std::string owner) {
  return [make = std::move(make), owner = std::move(owner)](Args... args) {
    if constexpr ((std::is_lvalue_reference_v<Args> && ...)) { // other arguments can be passed only once
      const std::string crash = early_end_of([&] { make(args...); }, "while it is made");
      if (!crash.empty()) throw PluginError(owner + " " + crash);
    }
    try {
      const Undisturbed process;
      return make(std::forward<Args>(args)...);
    } catch (const InputError&) { throw; } catch (const std::exception& error) {
      throw PluginError(owner + " cannot be made: " + error.what());
    }
  };
}

template <class Make>
void adopt(const Registry<Make>& brought, Registry<Make>& all, const std::string& plugin) {
  for (const auto& [description, make] : brought.entries()) {
    if (all.known(description.name))
      throw PluginError(plugin + ": there is a " + all.kind() + " called '" + description.name + "' already");
    all.add(description, guarded(make, plugin + ": " + brought.kind() + " '" + description.name + "'"));
  }
}

template <int Dim>
void adopt(const CatalogueOf<Dim>& brought, CatalogueOf<Dim>& all, const std::string& plugin) {
  adopt(brought.schemes, all.schemes, plugin);
  adopt(brought.searches, all.searches, plugin);
  adopt(brought.averagers, all.averagers, plugin);
  adopt(brought.boundaries, all.boundaries, plugin);
  adopt(brought.transfers, all.transfers, plugin);
}

template <class Make>
void append_names(const Registry<Make>& brought, std::vector<std::string>& names) {
  for (const std::string& name : brought.names()) names.push_back(brought.kind() + " " + name);
}

} // namespace

LoadedPlugin load_plugin(const std::filesystem::path& path, Catalogue& catalogue) {
  if (!std::filesystem::is_regular_file(path)) refuse(path, "there is no such file");
  const std::filesystem::path whole = std::filesystem::absolute(path);
  const auto bring = [&](Catalogue& brought) {
    const Undisturbed process;
    const Plugin& plugin = checked(opened(whole), path);
    plugin.enlist(brought);
    return std::string(plugin.compiler);
  };
  const std::string crash = early_end_of(
      [&] {
        Catalogue brought;
        bring(brought);
      },
      "while it is loaded");
  if (!crash.empty()) refuse(path, crash);

  LoadedPlugin loaded{.path = path, .compiler = {}, .brings = {}};
  Catalogue brought;
  try {
    loaded.compiler = bring(brought);
    const std::string owner = "plug-in " + path.string();
    adopt(brought.materials, catalogue.materials, owner);
    adopt(brought.in_2d, catalogue.in_2d, owner);
    adopt(brought.in_3d, catalogue.in_3d, owner);
  } catch (const PluginError&) { throw; } catch (const std::exception& error) {
    refuse(path, error.what());
  }
  append_names(brought.materials, loaded.brings);
  append_names(brought.in_2d.schemes, loaded.brings);
  append_names(brought.in_2d.searches, loaded.brings);
  append_names(brought.in_2d.averagers, loaded.brings);
  append_names(brought.in_2d.boundaries, loaded.brings);
  append_names(brought.in_2d.transfers, loaded.brings);
  return loaded;
}

} // namespace riedel
