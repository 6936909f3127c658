/// Which commit the program was built from; core/io/commit.cmake finds out whenever something is built.
#pragma once

namespace riedel {

/// Short hash, with "-dirty" behind it where the tree differed from the commit; "unknown" outside of a git checkout.
const char* commit();

} // namespace riedel
