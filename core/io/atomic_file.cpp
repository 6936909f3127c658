#include "core/io/atomic_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace riedel {

namespace {
[[noreturn]] void throw_unwritable(const std::filesystem::path& path, int reason) {
  throw RunError("cannot write " + path.string() + ": " + std::strerror(reason));
}
} // namespace

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail() const { throw_unwritable(path_, errno); }

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::flush_to_disk() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(); // some file systems have no fsync
}

void OutputFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
}

void write_atomically(const std::filesystem::path& path, std::string_view text) {
  const std::filesystem::path draft = path.string() + ".part";
  try {
    OutputFile file(draft);
    file.write(text);
    file.flush_to_disk();
    file.close();
    std::filesystem::rename(draft, path);
  } catch (const std::filesystem::filesystem_error& error) {
    ::unlink(draft.c_str());
    throw_unwritable(path, error.code().value());
  } catch (const RunError&) {
    ::unlink(draft.c_str());
    throw;
  }
}

} // namespace riedel
