#include "core/io/with_vtk.hpp"

namespace riedel {

Key key_for_vtk(const std::string& name, const std::string& doc) {
  Key key{.name = name, .default_value = with_vtk(), .unit = "", .bounds = {}, .doc = doc};
  if (!with_vtk()) key.left_out = {{"true", takes_vtk}};
  return key;
}

} // namespace riedel
