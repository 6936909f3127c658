#include "core/io/input_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace riedel {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw InputError(path.string() + ": cannot be read: " + why);
}

std::string too_large(std::uintmax_t maximum) {
  constexpr std::uintmax_t mebi = 1 << 20;
  return "is too large; allowed: at most " +
         (maximum < mebi ? std::to_string(maximum) + " bytes" : std::to_string(maximum / mebi) + " MiB");
}

} // namespace

std::string read_input_file(const fs::path& path, std::uintmax_t maximum) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse(path, error ? error.message() : std::strerror(ENOENT));
  if (fs::is_directory(status)) refuse(path, "is a folder, not a file");
  if (!fs::is_regular_file(status)) refuse(path, "is not a regular file but a device, a pipe or similar");
  if (fs::file_size(path, error) > maximum && !error) refuse(path, too_large(maximum));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, std::strerror(errno));
  std::string text;
  std::string block(1 << 16, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > maximum) refuse(path, too_large(maximum)); // files of /proc have a size of 0, others grow
  }
  if (!file.eof()) refuse(path, std::strerror(errno));
  return text;
}

} // namespace riedel
