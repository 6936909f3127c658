/// Files whose every write is checked, so that a full disk is an error and not a short file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace riedel {

/// A file being written. What cannot be written throws RunError with the path and the reason. A symbolic link is not
/// followed: nothing is written elsewhere than the path says.
class OutputFile {
public:
  /// `emptied`: created, or emptied; `only_new`: fails where there is something; `device`: as it is, links followed.
  enum class Opening { emptied, only_new, device };

  explicit OutputFile(std::filesystem::path path); ///< created, or emptied
  /// @param called the path that errors name
  OutputFile(const std::filesystem::path& path, std::filesystem::path called, Opening opening = Opening::emptied);
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

/// Writes beside the path under a name that nobody can foresee, and renames, so that a reader sees the old file or the
/// new one, whole. When something fails the old file stays as it was. A link at the path is replaced, not followed; a
/// device or a pipe is written to. @throws RunError
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Is it a name that `write_atomically` gives to the draft of a file called `name`, left behind by a program that was
/// killed meanwhile?
bool is_draft_of(std::string_view draft, std::string_view name);

} // namespace riedel
