#include "apps/output_folder.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

namespace riedel {

namespace {

namespace fs = std::filesystem;

void refuse_results(const fs::path& folder) {
  for (const char* result : {"case.toml", "history.csv", "summary.json"})
    if (fs::exists(folder / result))
      throw InputError("--out " + folder.string() + ": holds results already (" + result +
                       "); choose another folder, or --force to write over them");
}

void remove_results(const fs::path& folder) {
  for (const char* result : {"history.csv", "summary.json", "points.pvd", "domains.pvd"}) fs::remove(folder / result);
}

/// Permissions, quotas and read-only disks are best asked by trying.
void try_to_write(const fs::path& folder) {
  const fs::path trial = folder / ".riedel.trial";
  OutputFile(trial).close();
  fs::remove(trial);
}

} // namespace

void prepare_output_folder(const std::filesystem::path& folder, bool force) {
  try {
    if (fs::exists(folder) && !fs::is_directory(folder))
      throw InputError("--out " + folder.string() + ": is a file, not a folder");
    fs::create_directories(folder);
    if (!force) refuse_results(folder);
    try_to_write(folder);
    if (force) remove_results(folder);
  } catch (const fs::filesystem_error& error) {
    throw InputError("--out " + folder.string() + ": cannot be created: " + error.code().message());
  } catch (const RunError& error) {
    throw InputError("--out " + folder.string() + ": cannot be written to: " + error.what());
  }
}

} // namespace riedel
