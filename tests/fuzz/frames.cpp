// What is read back of the files for ParaView.
#include "core/io/vtk_reader.hpp"
#include "fuzz/support.hpp"
#include "fuzz/targets.hpp"

namespace riedel::fuzz {

void frame(std::string_view input) {
  static const Folder folder;
  const std::filesystem::path path = folder.file("frame.vtp", input);
  may_refuse([&] { require(read_frame(path).points() > 0, "a frame without points"); });
}

void frame_index(std::string_view input) {
  static const Folder folder;
  folder.file("domains.pvd", input);
  may_refuse([&] { (void)frame_files(folder.path()); });
}

} // namespace riedel::fuzz
