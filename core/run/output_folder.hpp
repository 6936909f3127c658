/// The folder to which a command writes its results.
#pragma once

#include "core/run/folder_lock.hpp"

namespace riedel {

/// During its lifetime the folder belongs to this process. It exists, is writable, and holds no results of an earlier
/// run, unless `force`: those stay until `replace`, to be called once the new run is certain to start.
class OutputFolder {
public:
  /// @param command shown to other processes that request the folder
  /// @throws InputError with the reason why the folder cannot be used; nothing in it has changed then
  OutputFolder(std::filesystem::path folder, const std::string& command, bool force);

  /// Removes earlier results, so that they cannot be mistaken for the new ones; other files, links' targets and
  /// case.toml (perhaps the case being run) stay. @throws RunError
  void replace();

  /// @throws InputError if it holds results
  void refuse_results() const;

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Whether it holds nothing from an earlier run, so that recording a failure overwrites nothing.
  [[nodiscard]] bool is_fresh() const;

private:
  std::filesystem::path folder_;
  FolderLock lock_;
};

/// Removes what a run wrote to that folder, including case.toml, and the folder itself if it is then empty. Other files
/// stay; so does a folder that is a symbolic link, with all its contents.
/// @throws InputError if another process writes there, RunError if something cannot be removed
void remove_run(const std::filesystem::path& folder, const std::string& command);

/// @throws InputError if another process writes to the folder
void require_idle(const std::filesystem::path& folder, const std::string& command);

/// Removes the file, or the link, of that name; a folder stays. @throws RunError
void remove_file(const std::filesystem::path& file);

} // namespace riedel
