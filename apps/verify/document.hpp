/// The tables of `riedel verify` as a part of a document.
#pragma once

#include <filesystem>

namespace riedel {

/// A Markdown file with a line `<!-- riedel verify -->` and, further down, a line `<!-- riedel verify ends -->`.
class VerifyDocument {
public:
  /// @throws InputError when the file cannot be read or lacks one of the lines
  explicit VerifyDocument(std::filesystem::path path);
  /// Puts the tables between the two lines, in place of what stood there. @throws RunError when it cannot be written
  void write(const std::string& tables) const;

private:
  std::filesystem::path path_;
  std::string before_, after_; ///< the file's text up to the first line and from the second one on, both included
};

} // namespace riedel
