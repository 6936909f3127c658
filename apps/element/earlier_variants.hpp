/// Folders that an earlier `--vary` has filled, beside which new results must not stand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riedel {

class EarlierVariants {
public:
  /// Those below a folder, named after settings such as "void_ratio=0.6". @throws InputError when there are, unless
  /// `force`
  EarlierVariants(std::filesystem::path folder, bool force);

  /// Removes their results and, when there is nothing else in them, them. A family of runs also has no case.toml in the
  /// folder above.
  /// @param input a case file that stays in any case   @throws InputError, RunError as `remove_run`
  void remove(const std::string& command, const std::filesystem::path& input, bool family) const;

private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> variants_;
};

} // namespace riedel
