/// Reads back the frames that a run wrote for ParaView. VTK's own readers are not used, since they end the program for
/// some kinds of damaged files.
#pragma once

#include "core/io/frame.hpp"

#include <filesystem>
#include <vector>

namespace riedel {

/// One frame of a time series.
struct FrameFile {
  double time = 0.0; ///< [s]
  std::filesystem::path path;
};

/// The frames listed by domains.pvd in the folder; none if there is no such file.
/// @throws InputError that names the file if it cannot be understood
std::vector<FrameFile> frame_files(const std::filesystem::path& folder);

/// A frame with domains and fields, in single precision, in two dimensions (.vtp) or three (.vtu), compressed by zlib,
/// by LZ4 (written by earlier builds), or not at all; a point's position is the mean of its domain's corners.
/// @throws InputError that names the file if it is missing or damaged
Frame read_frame(const std::filesystem::path& path);

} // namespace riedel
