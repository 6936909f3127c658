#include "core/run/output_folder.hpp"

#include "core/base/error.hpp"
#include "core/draw/drawn_fields.hpp"
#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <regex>

namespace riedel {

namespace {

namespace fs = std::filesystem;

/// Files that mark a folder as one with results.
constexpr std::array markers{"case.toml", "history.csv", "element.csv", "verify.csv", "campaign.json", "summary.json"};
/// All files written by biaxial, element and verify, except case.toml and frames; numbers and texts first.
constexpr std::array results{
    "history.csv",       "element.csv",   "output.txt",     "summary.json",      "points.pvd",      "domains.pvd",
    "verify.md",         "verify.csv",    "history.png",    "history.svg",       "void_ratio.png",  "shear_strain.png",
    "mean_pressure.png", "rate_norm.png", "friction.png",   "stress_strain.png", "compression.png", "shear.png",
    "p_q.png",           "cost.png",      "convergence.png"};
constexpr std::size_t numbers_and_texts = 8; ///< of `results`: essential for a run
constexpr std::array all_series{"points", "domains"};

/// Whether the path itself exists, even as a broken link.
bool is_there(const fs::path& path) { return fs::symlink_status(path).type() != fs::file_type::not_found; }
bool is_own_folder(const fs::path& path) { return fs::symlink_status(path).type() == fs::file_type::directory; }

void refuse_folders_in_the_way(const fs::path& folder) {
  for (std::size_t i = 0; i < numbers_and_texts; ++i)
    if (is_own_folder(folder / results[i]))
      throw InputError("--out " + folder.string() + ": " + results[i] + " is a folder, where a run writes a file");
}

/// The frames of a time series and their drafts, and no other files.
void remove_frames(const fs::path& folder, const std::string& series) {
  if (!is_own_folder(folder / series)) return;
  const std::regex frame(series + "_[0-9]{6,}[.]vt[pu]([.][0-9a-f]{16})?([.]part)?");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / series))
    if (std::regex_match(entry.path().filename().string(), frame)) remove_file(entry.path());
}

/// Drafts left by a killed program.
void remove_drafts(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const auto is_its_draft = [&](const char* result) { return is_draft_of(name, result); };
    if (std::ranges::any_of(results, is_its_draft) || std::ranges::any_of(markers, is_its_draft))
      remove_file(entry.path());
  }
}

void remove_results(const fs::path& folder) {
  try {
    for (const char* result : results) remove_file(folder / result);
    for (const DrawnField& field : drawn_fields) remove_file(folder / (std::string(field.name) + ".png"));
    for (const char* series : all_series) remove_frames(folder, series);
    remove_drafts(folder);
  } catch (const fs::filesystem_error& error) {
    throw RunError(folder.string() + ": the earlier results cannot be removed: " + error.code().message());
  }
}

fs::path made(const fs::path& folder) {
  try {
    if (fs::exists(folder) && !fs::is_directory(folder))
      throw InputError("--out " + folder.string() + ": is a file, not a folder");
    fs::create_directories(folder);
  } catch (const fs::filesystem_error& error) {
    throw InputError("--out " + folder.string() + ": cannot be created: " + error.code().message());
  }
  return folder;
}

/// Removes the folder if it is empty.
void remove_empty(const fs::path& folder) {
  std::error_code not_empty;
  if (is_own_folder(folder)) fs::remove(folder, not_empty);
}

} // namespace

OutputFolder::OutputFolder(fs::path folder, const std::string& command, bool force)
    : folder_(made(folder)), lock_(folder_, command) {
  if (!force) refuse_results();
  refuse_folders_in_the_way(folder_);
}

void OutputFolder::refuse_results() const {
  for (const char* result : markers)
    if (is_there(folder_ / result))
      throw InputError("--out " + folder_.string() + ": holds results already (" + result +
                       "); choose another folder, or --force to overwrite them");
}

void OutputFolder::replace() { remove_results(folder_); }

bool OutputFolder::is_fresh() const {
  return std::ranges::none_of(results, [&](const char* result) { return is_there(folder_ / result); });
}

void remove_run(const fs::path& folder, const std::string& command) {
  if (!is_own_folder(folder)) return;
  {
    const FolderLock lock(folder, command);
    remove_results(folder);
    remove_file(folder / "case.toml");
    for (const char* series : all_series) remove_empty(folder / series);
  }
  remove_empty(folder);
}

void require_idle(const fs::path& folder, const std::string& command) {
  if (is_own_folder(folder)) const FolderLock lock(folder, command);
}

void remove_file(const fs::path& file) {
  std::error_code error;
  if (!is_own_folder(file)) fs::remove(file, error);
  if (error) throw RunError(file.string() + ": cannot be removed: " + error.message());
}

} // namespace riedel
