#include "core/campaign/child_process.hpp"

#include "core/base/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace riedel {

namespace {

constexpr const char* this_program = "/proc/self/exe";

[[noreturn]] void become(const std::vector<char*>& words, int messages, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127); // the parent died before the line above
  setpgid(0, 0);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  execv(this_program, words.data());
  _exit(127);
}

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw RunError(std::string("cannot create a pipe for another process: ") + std::strerror(errno));
  std::vector<char*> pointers{const_cast<char*>("riedel")}; // execv does not change them
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become(pointers, ends[1], parent);
  close(ends[1]);
  pipe_ = ends[0];
  if (process_ < 0) {
    const std::string why = std::strerror(errno);
    close(pipe_);
    throw RunError("cannot start another process: " + why);
  }
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(pipe_);
}

void ChildProcess::read_messages() {
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = read(pipe_, bytes.data(), bytes.size())) > 0;)
    messages_.append(bytes.data(), static_cast<std::size_t>(count));
}

bool ChildProcess::running() {
  if (process_ < 0) return false;
  int status = 0;
  const bool ended = waitpid(process_, &status, WNOHANG) == process_;
  read_messages();
  if (!ended) return true;
  process_ = -1;
  ending_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return false;
}

void ChildProcess::send(int signal) const {
  if (process_ > 0) kill(process_, signal);
}

} // namespace riedel
