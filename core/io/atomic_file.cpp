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

OutputFile::OutputFile(std::filesystem::path path) : OutputFile(path, path) {}

OutputFile::OutputFile(const std::filesystem::path& path, std::filesystem::path called)
    : called_(std::move(called)), descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail() const { throw_unwritable(called_, errno); }

void OutputFile::write(std::string_view bytes) {
  const auto all = static_cast<std::int64_t>(bytes.size());
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, size_); // devices cannot
      throw_unwritable(called_, reason);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += all;
}

void OutputFile::flush_to_disk() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(); // some file systems have no fsync
}

void OutputFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path draft = path;
  draft += ".part";
  try {
    OutputFile file(draft, path);
    file.write(bytes);
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
