/// A folder to which only one process at a time writes.
#pragma once

#include <filesystem>
#include <sys/file.h>

namespace riedel {

/// Holds a folder by a lock on a file in it, which shows others who holds it. The system releases the lock when the
/// process ends in any way.
class FolderLock {
public:
  using Locker = int (*)(int, int); ///< as flock(2)

  /// @param command shown to processes that are refused
  /// @throws InputError that names the process that holds the folder, or why the folder cannot be written to. If the
  /// file system does not support locks, there is a warning and the folder is not protected.
  FolderLock(std::filesystem::path folder, const std::string& command, Locker lock = ::flock);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  static constexpr const char* file_name = ".riedel.lock";
  /// Part of every refusal of a locked folder.
  static constexpr const char* refusal = "is being written to by";

private:
  [[nodiscard]] bool take(Locker lock);
  [[nodiscard]] bool is_still_there() const;
  void tell(const std::string& command) const;
  [[noreturn]] void refuse() const;

  std::filesystem::path folder_, file_;
  int descriptor_ = -1;
};

} // namespace riedel
