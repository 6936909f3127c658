/// The folder that a command writes its results to.
#pragma once

#include "core/run/folder_lock.hpp"

namespace riedel {

/// While it lives the folder is this process's own. It exists, can be written to, and holds no results of an earlier
/// run, unless `force`: those stay until `replace`, to be called when the new run is known to begin.
class OutputFolder {
public:
  /// @param command told to others who want the folder meanwhile
  /// @throws InputError with the reason why the folder cannot be had; nothing in it has changed then
  OutputFolder(std::filesystem::path folder, const std::string& command, bool force);

  /// Removes earlier results, so that nobody takes the old ones for the new; other files, links' targets and case.toml
  /// stay, which may be the very case that is being run. @throws RunError
  void replace();

  /// @throws InputError when it holds results
  void refuse_results() const;

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Does it hold nothing that an earlier run left? Then a word of failure covers nothing up.
  [[nodiscard]] bool is_fresh() const;

private:
  std::filesystem::path folder_;
  FolderLock lock_;
};

/// Removes what a run of that folder wrote, case.toml too, and the folder itself when it is empty then. What else there
/// is stays; so does a folder that is a symbolic link, with all it holds.
/// @throws InputError when another process writes there, RunError when something cannot be removed
void remove_run(const std::filesystem::path& folder, const std::string& command);

/// @throws InputError when another process writes to the folder
void require_idle(const std::filesystem::path& folder, const std::string& command);

/// Removes the file, or the link, of that name; a folder stays. @throws RunError
void remove_file(const std::filesystem::path& file);

} // namespace riedel
