/// Reads back the frames that a run wrote for ParaView. VTK's own readers end the program for some of what a damaged
/// file may hold, so they take no part in it.
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

/// The frames that domains.pvd in the folder lists; none if there is no such file.
/// @throws InputError that names the file when it cannot be understood
std::vector<FrameFile> frame_files(const std::filesystem::path& folder);

/// A frame with domains and fields, to float precision, in two dimensions (.vtp) or three (.vtu), compressed by
/// zlib, or by LZ4 as earlier builds wrote it, or not at all; a point's position is the mean of its domain's corners.
/// @throws InputError that names the file when it is missing or damaged
Frame read_frame(const std::filesystem::path& path);

} // namespace riedel
