/// Names of files and folders that come from somebody else's words.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// The name of something that lies right in a folder: no path, not "." or "..", nothing hidden, no control characters,
/// no backslash, and of a length that file systems take. What is read from a file and is to be a name must be one.
bool is_file_name(std::string_view text);

/// A name for a text, which it resembles: letters that some file system refuses become "_", and a long text is cut
/// and ends with a number that stands for all of it.
std::string file_name_for(const std::string& text);

} // namespace riedel
