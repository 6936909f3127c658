/// Replaces vtk_writer.cpp in a build without VTK.
#include "core/base/error.hpp"
#include "core/io/vtk_writer.hpp"
#include "core/io/with_vtk.hpp"

namespace riedel {

bool with_vtk() { return false; }

SeriesWriter::SeriesWriter(std::filesystem::path directory) : directory_(std::move(directory)) {
  throw InputError("a series of frames for ParaView " + std::string(takes_vtk));
}
void SeriesWriter::write(const Frame&) {}

} // namespace riedel
