/// Files with every write checked, so that a full disk is an error and not a truncated file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace riedel {

/// A file being written. Failed writes throw RunError with the path and the reason. Symbolic links are not followed, so
/// that nothing is written outside the given path.
class OutputFile {
public:
  /// `emptied`: created, or emptied; `only_new`: fails if something exists; `device`: opened as it is, following links.
  enum class Opening { emptied, only_new, device };

  explicit OutputFile(std::filesystem::path path); ///< created, or emptied
  /// @param called the path shown in errors
  OutputFile(const std::filesystem::path& path, std::filesystem::path called, Opening opening = Opening::emptied);
  ~OutputFile(); ///< closes without reporting errors: call close() to get them
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Passed to the system at once. A partial write is undone, so that the file ends where it did.
  void write(std::string_view bytes);
  void flush_to_disk(); ///< waits until the data is on the disk
  void close();

private:
  [[noreturn]] void fail() const;

  std::filesystem::path called_;
  int descriptor_;
  std::int64_t size_ = 0; ///< written so far
};

/// Writes next to the path under an unpredictable name, then renames, so that a reader sees either the complete old
/// file or the complete new one. If anything fails, the old file is unchanged. A link at the path is replaced, not
/// followed; a device or a pipe is written to. @throws RunError
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Whether `write_atomically` gives such a name to the draft of a file called `name`, which a killed program may leave.
bool is_draft_of(std::string_view draft, std::string_view name);

} // namespace riedel
