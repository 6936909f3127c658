/// Threads that the loops over points will run on.
#pragma once

namespace riedel {

/// @throws RunError when the system does not give this process so many threads
void require_threads(int threads);

} // namespace riedel
