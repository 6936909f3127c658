#include "core/io/atomic_file.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <random>
#include <unistd.h>
#include <utility>

namespace riedel {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view draft_ending = ".part";
constexpr std::size_t draft_digits = 16, longest_name = 255;

[[noreturn]] void throw_unwritable(const fs::path& path, int reason) {
  throw RunError("cannot write " + path.string() + ": " +
                 (reason == ELOOP ? "is a symbolic link" : std::strerror(reason)));
}

int flags_of(OutputFile::Opening opening) {
  switch (opening) {
  case OutputFile::Opening::emptied:
    return O_WRONLY | O_CLOEXEC | O_CREAT | O_NOFOLLOW | O_TRUNC;
  case OutputFile::Opening::only_new:
    return O_WRONLY | O_CLOEXEC | O_CREAT | O_NOFOLLOW | O_EXCL;
  case OutputFile::Opening::device:
    return O_WRONLY | O_CLOEXEC | O_APPEND;
  }
  return O_RDONLY;
}

/// As much of a file's name as leaves room for the rest of a draft's name.
std::string_view stem_of_draft(std::string_view name) {
  return name.substr(0, longest_name - 1 - draft_digits - draft_ending.size());
}

fs::path draft_of(const fs::path& path) {
  std::random_device chance;
  std::string name(stem_of_draft(path.filename().native()));
  name += '.';
  for (std::size_t i = 0; i < draft_digits; ++i) name += "0123456789abcdef"[chance() % 16];
  return path.parent_path() / (name += draft_ending);
}

/// A target that cannot be replaced by renaming a file: a pipe, or /dev/stdout wherever it leads.
bool is_device(const fs::path& path) {
  std::error_code unknown;
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::character || type == fs::file_type::fifo) return true;
  if (!fs::is_symlink(path, unknown)) return false;
  const std::string home = fs::canonical(fs::absolute(path, unknown).parent_path(), unknown).string() + "/";
  return home == "/dev/" || home.starts_with("/proc/");
}

void write_to_device(const fs::path& path, std::string_view bytes) {
  OutputFile file(path, path, OutputFile::Opening::device);
  file.write(bytes);
  file.close();
}

} // namespace

OutputFile::OutputFile(fs::path path) : OutputFile(path, path) {}

OutputFile::OutputFile(const fs::path& path, fs::path called, Opening opening)
    : called_(std::move(called)), descriptor_(::open(path.c_str(), flags_of(opening), 0666)) {
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
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, size_); // fails for devices
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

void write_atomically(const fs::path& path, std::string_view bytes) {
  if (is_device(path)) return write_to_device(path, bytes);
  const fs::path draft = draft_of(path);
  try {
    OutputFile file(draft, path, OutputFile::Opening::only_new);
    file.write(bytes);
    file.flush_to_disk();
    file.close();
    fs::rename(draft, path);
  } catch (const fs::filesystem_error& error) {
    ::unlink(draft.c_str());
    throw_unwritable(path, error.code().value());
  } catch (const RunError&) {
    ::unlink(draft.c_str());
    throw;
  }
}

bool is_draft_of(std::string_view draft, std::string_view name) {
  const std::string_view stem = stem_of_draft(name);
  if (draft.size() != stem.size() + 1 + draft_digits + draft_ending.size()) return false;
  const std::string_view digits = draft.substr(stem.size() + 1, draft_digits);
  return draft.starts_with(stem) && draft[stem.size()] == '.' && draft.ends_with(draft_ending) &&
         digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

} // namespace riedel
