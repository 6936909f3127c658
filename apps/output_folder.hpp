/// The folder that a run writes to.
#pragma once

#include <filesystem>

namespace riedel {

/// Makes the folder ready: it exists, can be written to, and holds no results of an earlier run unless `force`. With
/// `force`, the earlier results are removed, so that nobody takes the old ones for the new; other files stay.
/// @throws InputError with the reason
void prepare_output_folder(const std::filesystem::path& folder, bool force);

} // namespace riedel
