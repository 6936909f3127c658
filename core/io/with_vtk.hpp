/// VTK writes the files for ParaView and the pictures (PNG). A build with RIEDEL_WITH_VTK=OFF lacks both.
#pragma once

#include "core/base/parameters.hpp"

namespace riedel {

/// Whether this build has VTK.
bool with_vtk();

/// How to get what needs VTK, as the end of a sentence.
inline constexpr const char* takes_vtk =
    "needs VTK, which this build lacks: configure Riedel with -DRIEDEL_WITH_VTK=ON (Debian's libvtk9-dev)";

/// A switch for something that needs VTK: on by default; without VTK it is off, and `true` is refused.
Key key_for_vtk(const std::string& name, const std::string& doc);

} // namespace riedel
