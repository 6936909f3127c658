#include "fuzz/support.hpp"

#include <algorithm>
#include <fstream>
#include <stdlib.h>

namespace riedel::fuzz {

namespace fs = std::filesystem;

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

Folder::Folder() {
  const fs::path memory = "/dev/shm"; // so that a million files do not wear a disk
  std::string name = ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "riedel_fuzz_XXXXXX").string();
  require(::mkdtemp(name.data()) != nullptr, "no folder for the files");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path Folder::file(const fs::path& name, std::string_view bytes) const {
  std::ofstream file(path_ / name, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(static_cast<bool>(file.flush()), "a file cannot be written");
  return path_ / name;
}

std::vector<std::string_view> parts(std::string_view input, std::size_t count) {
  constexpr std::string_view border = "----\n";
  std::vector<std::string_view> all(count);
  for (std::string_view& part : all) {
    const std::size_t end = std::min(input.find(border), input.size());
    part = input.substr(0, end);
    input.remove_prefix(std::min(end + border.size(), input.size()));
  }
  return all;
}

} // namespace riedel::fuzz
