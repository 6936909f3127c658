/// The project's own sources, as text.
#pragma once

#include <string>
#include <vector>

namespace riedel::architecture {

struct SourceFile {
  std::string path; ///< from the top of the tree, such as "core/base/types.hpp"
  std::string text;
};

/// Every .hpp and .cpp below the folders that hold sources, in the order of their paths.
std::vector<SourceFile> read_tree(const std::string& root);

} // namespace riedel::architecture
