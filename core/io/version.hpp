/// The version of Riedel, for files and for `--version`.
#pragma once

#include <string>

namespace riedel {

std::string version(); ///< "riedel 0.2.0 (commit 63db63f)"; includes commit()

} // namespace riedel
