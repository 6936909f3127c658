/// A part of a document that a command fills in.
#pragma once

#include <filesystem>
#include <string>

namespace riedel {

/// A Markdown file with a line `<!-- MARK -->` and, further down, a line `<!-- MARK ends -->`.
class MarkedDocument {
public:
  /// @param mark such as "riedel verify" @throws InputError if the file cannot be read or lacks one of the lines
  MarkedDocument(std::filesystem::path path, const std::string& mark);
  /// Replaces what is between the two lines by the text. @throws RunError if it cannot be written
  void write(const std::string& text) const;

private:
  std::filesystem::path path_;
  std::string before_, after_; ///< the file's text up to the first line and from the second line on, inclusive
};

} // namespace riedel
