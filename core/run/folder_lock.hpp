/// A folder that one process at a time writes to.
#pragma once

#include <filesystem>
#include <sys/file.h>

namespace riedel {

/// Holds a folder by a lock on a file in it, which tells others who holds it. The system takes the lock away from a
/// process that ends, however it ends.
class FolderLock {
public:
  using Locker = int (*)(int, int); ///< as flock(2)

  /// @param command told to those who are refused
  /// @throws InputError that names the process that holds the folder, or why the folder cannot be written to. Where the
  /// file system knows no locks there is a warning, and the folder is held in name only.
  FolderLock(std::filesystem::path folder, const std::string& command, Locker lock = ::flock);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  static constexpr const char* file_name = ".riedel.lock";
  /// What every refusal of a held folder says.
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
