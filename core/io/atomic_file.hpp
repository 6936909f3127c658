/// Text files whose every write is checked, so that a full disk is an error and not a short file.
#pragma once

#include <filesystem>
#include <string_view>

namespace riedel {

/// A file being written. What cannot be written throws RunError with the path and the reason.
class OutputFile {
public:
  explicit OutputFile(std::filesystem::path path); ///< created, or emptied
  ~OutputFile();                                   ///< closes without a word: call close() to know
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text); ///< handed to the system at once
  void flush_to_disk();              ///< waits until the disk has it
  void close();

private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  int descriptor_;
};

/// Writes under a temporary name and renames, so that a reader sees the old text or the new one, whole. When something
/// fails the old file stays as it was. @throws RunError
void write_atomically(const std::filesystem::path& path, std::string_view text);

} // namespace riedel
