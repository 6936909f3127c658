/// Folders of an earlier `--vary`, with which new results must not be mixed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riedel {

class EarlierVariants {
public:
  /// Those in a folder, named after settings such as "void_ratio=0.6". @throws InputError if there are any, unless
  /// `force`
  EarlierVariants(std::filesystem::path folder, bool force);

  /// Removes their results, and the folders if nothing else is left in them. For a family of runs it also removes the
  /// case.toml in the folder above.
  /// @param input a case file that is never removed   @throws InputError, RunError as `remove_run`
  void remove(const std::string& command, const std::filesystem::path& input, bool family) const;

private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> variants_;
};

} // namespace riedel
