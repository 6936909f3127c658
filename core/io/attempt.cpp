#include "core/io/attempt.hpp"

#include "core/base/error.hpp"
#include "core/base/parameters.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace riedel {

namespace {

constexpr int returned = 86; ///< exit code of a copy that finished

/// Collects what is printed: shown only if the work ends early, since it is printed again in the real run.
class Printed {
public:
  Printed() : file_(memfd_create("printed", MFD_CLOEXEC)) {}
  ~Printed() {
    if (file_ >= 0) close(file_);
  }
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  void collect() const { // in the copy
    const int to = file_ >= 0 ? file_ : open("/dev/null", O_WRONLY);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(to, stream);
  }
  void show() const {
    std::array<char, 4096> text; // the beginning is enough
    const ssize_t size = pread(file_, text.data(), text.size(), 0);
    if (size > 0) std::fwrite(text.data(), 1, static_cast<std::size_t>(size), stderr);
  }

private:
  int file_;
};

[[noreturn]] void work_and_leave(const std::function<void()>& work, const Printed& printed) {
  prctl(PR_SET_PDEATHSIG, SIGKILL); // otherwise an endless loop would outlive an interrupted program
  printed.collect();
  try {
    work();
  } catch (...) { // reported in the real run
  }
  _exit(returned);
}

/// Status of a child that has ended; nothing if it had to be killed.
std::optional<int> status_of(pid_t child, double seconds) {
  using namespace std::chrono;
  const auto end = steady_clock::now() + duration<double>(seconds);
  int status = 0;
  for (auto pause = 200us; steady_clock::now() < end; pause = std::min<microseconds>(2 * pause, 10ms)) {
    const pid_t answer = waitpid(child, &status, WNOHANG);
    if (answer == child) return status;
    if (answer < 0 && errno != EINTR) return returned << 8; // its status was collected elsewhere
    std::this_thread::sleep_for(pause);
  }
  kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  return std::nullopt;
}

} // namespace

double time_for_foreign_code() {
  constexpr double standard = 10.0;
  const char* const wish = std::getenv("RIEDEL_PLUGIN_TIMEOUT");
  if (wish == nullptr || *wish == '\0') return standard;
  char* rest = nullptr;
  const double seconds = std::strtod(wish, &rest);
  if (*rest == '\0' && seconds > 0.0 && seconds <= 1e6) return seconds;
  throw InputError("RIEDEL_PLUGIN_TIMEOUT is '" + std::string(wish) + "'; allowed: seconds, more than 0, at most 1e6");
}

std::string early_end_of(const std::function<void()>& work, const std::string& when) {
  const double seconds = time_for_foreign_code();
  const Printed printed;
  const pid_t copy = fork();
  if (copy < 0) return ""; // no copy can be made: the real run will show the problem
  if (copy == 0) work_and_leave(work, printed);
  const std::optional<int> status = status_of(copy, seconds);
  if (status && WIFEXITED(*status) && WEXITSTATUS(*status) == returned) return "";
  printed.show();
  if (!status)
    return "does not come back " + when + ": ended after " + short_text(seconds) + " s (RIEDEL_PLUGIN_TIMEOUT)";
  if (WIFSIGNALED(*status))
    return "crashes " + when + ": signal " + std::to_string(WTERMSIG(*status)) + " (" + strsignal(WTERMSIG(*status)) +
           ")";
  return "ends the program " + when + ": exit with code " + std::to_string(WEXITSTATUS(*status));
}

} // namespace riedel
