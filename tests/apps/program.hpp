/// The program as a separate process, as a user starts it.
#pragma once

#include "temporary_folder.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

namespace riedel::test {

using Words = std::vector<std::string>;

struct Outcome {
  int code = -1; ///< exit code; −1 when a signal ended it
  std::string out, err;
};

/// A started program; its output goes to two files.
class Process {
public:
  /// @param largest_file no file may grow beyond it, as if the disk were full then [bytes]
  /// @param name before those of the two files, for programs that run at the same time
  Process(const TemporaryFolder& folder, const Words& words, rlim_t largest_file = RLIM_INFINITY,
          const std::string& name = "")
      : out_(folder / (name + "stdout")), err_(folder / (name + "stderr")) {
    std::vector<char*> argv{const_cast<char*>(RIEDEL_PROGRAM)};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) become(argv, largest_file);
  }
  ~Process() {
    if (pid_ > 0) (void)finish(SIGKILL);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] bool running() { return ::waitpid(pid_, &status_, WNOHANG) == 0 || (pid_ = 0, false); }
  void send(int signal) const { ::kill(pid_, signal); }
  /// Waits for its end, after a signal if there is one.
  Outcome finish(int signal = 0) {
    if (pid_ > 0) {
      if (signal != 0) send(signal);
      ::waitpid(pid_, &status_, 0);
    }
    pid_ = 0;
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, file_content(out_), file_content(err_)};
  }

private:
  [[noreturn]] void become(const std::vector<char*>& argv, rlim_t largest_file) const {
    const int mode = O_WRONLY | O_CREAT | O_TRUNC;
    ::dup2(::open(out_.c_str(), mode, 0666), STDOUT_FILENO);
    ::dup2(::open(err_.c_str(), mode, 0666), STDERR_FILENO);
    const rlimit limit{largest_file, largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);
    ::setenv("OMP_WAIT_POLICY", "passive", 1); // tests that run side by side must not spin on one another's cores
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }

  std::filesystem::path out_, err_;
  pid_t pid_ = 0;
  int status_ = 0;
};

inline Outcome run(const TemporaryFolder& folder, const Words& words, rlim_t largest_file = RLIM_INFINITY) {
  return Process(folder, words, largest_file).finish();
}

/// `riedel biaxial` on few cells, fast and short, with results in `out`; `more` comes last and so takes precedence.
inline Words coarse_case(const std::filesystem::path& out, const Words& more = {}) {
  Words words{"biaxial", "--out", out.string()};
  if (std::ranges::find(more, "--threads") == more.end()) words.insert(words.end(), {"--threads", "1"});
  for (const char* setting :
       {"grid.cells=[8,28]", "nonlocal.length=5e-3", "loading.speed=0.4", "loading.ramp_time=1e-3",
        "loading.final_strain=0.004", "output.frames_every_strain=0.001"})
    words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The content of every file below a folder, by its relative path.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), folder).string()] = file_content(entry.path());
  return files;
}

} // namespace riedel::test
