/// The commit from which the program was built; determined by core/io/commit.cmake at every build.
#pragma once

namespace riedel {

/// Short hash, followed by "-dirty" if the tree differed from the commit; "unknown" outside a git checkout.
const char* commit();

} // namespace riedel
