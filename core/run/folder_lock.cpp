#include "core/run/folder_lock.hpp"

#include "core/base/error.hpp"
#include "core/io/messages.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace riedel {

namespace {

/// A killed process releases its locks shortly after it has disappeared.
constexpr auto patience = std::chrono::milliseconds(500), between_tries = std::chrono::milliseconds(20);

std::string host() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown host";
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &utc);
  return text.data();
}

/// Reads the lines "pid …", "host …", "since …", "command …" of the holder's file.
std::string holder(const std::filesystem::path& file) {
  std::ifstream lines(file);
  std::string process = "another process", place, since, command;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("pid ")) process = "process " + line.substr(4);
    if (line.starts_with("host ")) place = " on " + line.substr(5);
    if (line.starts_with("since ")) since = " since " + line.substr(6);
    if (line.starts_with("command ")) command = ", '" + line.substr(8) + "'";
  }
  return process + place + since + command;
}

bool means_no_locks(int error) {
  return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP || error == EINVAL || error == EBADF;
}

} // namespace

FolderLock::FolderLock(std::filesystem::path folder, const std::string& command, Locker lock)
    : folder_(std::move(folder)), file_(folder_ / file_name) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!take(lock)) {
    if (std::chrono::steady_clock::now() > deadline) refuse();
    std::this_thread::sleep_for(between_tries);
  }
  tell(command);
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  if (is_still_there()) ::unlink(file_.c_str()); // while the lock is held, so that only its own file is removed
  ::close(descriptor_);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : folder_(std::move(other.folder_)),
      file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

/// False if another process holds the folder.
bool FolderLock::take(Locker lock) {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor_ < 0)
    throw InputError("--out " + folder_.string() + ": cannot be written to: " +
                     (errno == ELOOP ? std::string(file_name) + " is a symbolic link" : std::strerror(errno)));
  if (lock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
    if (is_still_there()) return true; // otherwise the previous holder has just removed the opened file
  } else if (means_no_locks(errno)) {
    print_warning(folder_.string() + ": the file system does not support locks (" + std::strerror(errno) +
                  "): make sure that no other run writes there");
    return true;
  }
  ::close(std::exchange(descriptor_, -1));
  return false;
}

bool FolderLock::is_still_there() const {
  struct stat locked {
  }, there{};
  return ::fstat(descriptor_, &locked) == 0 && ::lstat(file_.c_str(), &there) == 0 && locked.st_ino == there.st_ino &&
         locked.st_dev == there.st_dev;
}

void FolderLock::tell(const std::string& command) const {
  std::string line = command;
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  const std::string text =
      "pid " + std::to_string(::getpid()) + "\nhost " + host() + "\nsince " + now() + "\ncommand " + line + "\n";
  if (::ftruncate(descriptor_, 0) == 0 &&
      ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()))
    return;
  const std::string why = std::strerror(errno);
  ::unlink(file_.c_str());
  ::close(descriptor_);
  throw InputError("--out " + folder_.string() + ": cannot be written to: " + why);
}

void FolderLock::refuse() const {
  throw InputError("--out " + folder_.string() + ": " + refusal + " " + holder(file_) +
                   "; wait for it to end, or choose another folder");
}

} // namespace riedel
