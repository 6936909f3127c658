#include "core/io/version.hpp"

#include "core/io/commit.hpp"

namespace riedel {

std::string version() { return std::string("riedel " RIEDEL_VERSION " (commit ") + commit() + ")"; }

} // namespace riedel
