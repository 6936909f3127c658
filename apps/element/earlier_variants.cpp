#include "apps/element/earlier_variants.hpp"

#include "core/base/error.hpp"
#include "core/run/output_folder.hpp"

namespace riedel {

namespace {

namespace fs = std::filesystem;

bool is_variant(const fs::directory_entry& entry) {
  const fs::path& path = entry.path();
  return !entry.is_symlink() && entry.is_directory() && path.filename().string().find('=') != std::string::npos &&
         fs::exists(path / "case.toml") && fs::exists(path / "element.csv");
}

bool same(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing);
}

} // namespace

EarlierVariants::EarlierVariants(fs::path folder, bool force) : folder_(std::move(folder)) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
    if (is_variant(entry)) variants_.push_back(entry.path());
  if (!force && !variants_.empty())
    throw InputError("--out " + folder_.string() + ": holds results already (" + variants_.front().filename().string() +
                     "); choose another folder, or --force to overwrite them");
}

void EarlierVariants::remove(const std::string& command, const fs::path& input, bool family) const {
  for (const fs::path& variant : variants_) {
    if (same(variant / "case.toml", input))
      OutputFolder(variant, command, true).replace();
    else
      remove_run(variant, command);
  }
  if (family && !same(folder_ / "case.toml", input)) remove_file(folder_ / "case.toml");
}

} // namespace riedel
