/// Names of files and folders made from external texts.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// Whether it is a valid name directly in a folder: no path, not "." or "..", nothing hidden, no control characters, no
/// backslash, and no longer than file systems allow. Names read from a file must pass this test.
bool is_file_name(std::string_view text);

/// A file name that resembles a text: letters that some file systems refuse become "_", and a long text is cut and ends
/// with a hash of the whole text.
std::string file_name_for(const std::string& text);

} // namespace riedel
