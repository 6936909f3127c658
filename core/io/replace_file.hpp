/// Files that are either whole or not there at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace riedel {

/// Writes `bytes` to a temporary file beside `path`, which then takes the name: a reader never sees half a file, and
/// the file of that name stays as it was when the disk is full. Throws RunError with path and reason.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

/// Creates the directory and those above it. Throws InputError with path and reason.
void make_directory(const std::filesystem::path& path);

} // namespace riedel
