/// VTK makes the files for ParaView and the pictures (PNG). A build with RIEDEL_WITH_VTK=OFF does without.
#pragma once

#include "core/base/parameters.hpp"

namespace riedel {

/// Whether this build has VTK.
bool with_vtk();

/// How to get what needs it, as the end of a sentence.
inline constexpr const char* takes_vtk =
    "takes VTK, which this build does without: configure Riedel with -DRIEDEL_WITH_VTK=ON (Debian's libvtk9-dev)";

/// A switch for something that VTK makes: on by default, and off without VTK, where `true` is refused.
Key key_for_vtk(const std::string& name, const std::string& doc);

} // namespace riedel
