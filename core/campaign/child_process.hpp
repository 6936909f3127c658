/// This program started once more, with other words.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace riedel {

/// Runs beside this process, in a group of its own so that Ctrl-C is this process's to pass on, and is killed by the
/// system when this process dies, however it dies. What it prints to standard output is dropped.
class ChildProcess {
public:
  /// @param words behind the program's name   @throws RunError when no process can be had
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess(); ///< kills it if it runs
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To be asked now and then, lest it wait for somebody to read what it prints to standard error.
  [[nodiscard]] bool running();
  void send(int signal) const;
  /// How it ended: its exit code, or minus the signal that ended it.
  [[nodiscard]] int ending() const { return ending_; }
  [[nodiscard]] const std::string& messages() const { return messages_; } ///< what it printed to standard error

private:
  void read_messages();

  pid_t process_ = -1;
  int pipe_ = -1; ///< end to read from
  int ending_ = 0;
  std::string messages_;
};

} // namespace riedel
