/// This program, started again with other arguments.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace riedel {

/// Runs alongside this process, in its own process group, so that this process decides whether to pass on Ctrl-C. The
/// system kills it when this process ends in any way. Its standard output is discarded.
class ChildProcess {
public:
  /// @param words arguments after the program's name @throws RunError if no process can be started
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess(); ///< kills it if it is running
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To be called now and then, so that it does not block on a full pipe of standard error.
  [[nodiscard]] bool running();
  void send(int signal) const;
  /// How it ended: its exit code, or minus the signal that ended it.
  [[nodiscard]] int ending() const { return ending_; }
  [[nodiscard]] const std::string& messages() const { return messages_; } ///< what it printed to standard error

private:
  void read_messages();

  pid_t process_ = -1;
  int pipe_ = -1; ///< the read end
  int ending_ = 0;
  std::string messages_;
};

} // namespace riedel
