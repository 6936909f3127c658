#include "apps/output_folder.hpp"

#include "apps/drawn_fields.hpp"
#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

#include <regex>

namespace riedel {

namespace {

namespace fs = std::filesystem;

void refuse_results(const fs::path& folder) {
  for (const char* result : {"case.toml", "history.csv", "element.csv", "verify.csv", "campaign.json", "summary.json"})
    if (fs::exists(folder / result))
      throw InputError("--out " + folder.string() + ": holds results already (" + result +
                       "); choose another folder, or --force to write over them");
}

/// The frames of a time series, and no file of another name.
void remove_frames(const fs::path& folder, const std::string& series) {
  if (!fs::is_directory(folder / series)) return;
  const std::regex frame(series + "_[0-9]{6,}[.]vt[pu]([.]part)?");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / series))
    if (std::regex_match(entry.path().filename().string(), frame)) fs::remove(entry.path());
}

/// All but case.toml, which may be the very case that is being run.
void remove_results(const fs::path& folder) {
  for (const char* result : {"history.csv", "element.csv", "output.txt", "summary.json", "points.pvd", "domains.pvd",
                             "history.png", "history.svg", "void_ratio.png", "stress_strain.png", "compression.png",
                             "friction.png", "shear.png", "verify.md", "verify.csv", "convergence.png", "cost.png"})
    fs::remove(folder / result);
  for (const DrawnField& field : drawn_fields) fs::remove(folder / (std::string(field.name) + ".png"));
  for (const char* series : {"points", "domains"}) remove_frames(folder, series);
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
