#include "core/io/replace_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace riedel {

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::error_code ignored;
  const auto fail = [&](const std::string& reason) {
    std::filesystem::remove(temporary, ignored);
    throw RunError("cannot write " + path.string() + ": " + reason);
  };

  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close(); // flushes: a full disk shows only now
  if (!out) fail(errno != 0 ? std::strerror(errno) : "output error");

  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) fail(error.message());
}

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw InputError("cannot create the directory " + path.string() + ": " + error.message());
}

} // namespace riedel
