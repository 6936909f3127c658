/// Files whose every write is checked, so that a full disk is an error and not a short file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace riedel {

/// A file being written. What cannot be written throws RunError with the path and the reason.
class OutputFile {
public:
  explicit OutputFile(std::filesystem::path path); ///< created, or emptied
  /// @param called the path that errors name
  OutputFile(const std::filesystem::path& path, std::filesystem::path called);
  ~OutputFile(); ///< closes without a word: call close() to know
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Handed to the system at once. What fits only in part is taken back, so that the file ends where it did.
  void write(std::string_view bytes);
  void flush_to_disk(); ///< waits until the disk has it
  void close();

private:
  [[noreturn]] void fail() const;

  std::filesystem::path called_;
  int descriptor_;
  std::int64_t size_ = 0; ///< written so far
};

/// Writes under a temporary name and renames, so that a reader sees the old file or the new one, whole. When something
/// fails the old file stays as it was. @throws RunError
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

} // namespace riedel
