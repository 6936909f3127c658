/// Threads for the loops over points.
#pragma once

namespace riedel {

/// @throws RunError if the system does not give this process that many threads
void require_threads(int threads);

} // namespace riedel
