#include "core/base/undisturbed.hpp"

#include <clocale>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace riedel {

Undisturbed::Undisturbed() {
  for (int s = 1; s < signals; ++s) sigaction(s, nullptr, &handlers_[static_cast<std::size_t>(s)]);
  std::fflush(stdout);
  for (int d = 0; d < 3; ++d) streams_[static_cast<std::size_t>(d)] = fcntl(d, F_DUPFD_CLOEXEC, 3);
  if (streams_[2] >= 0) dup2(STDERR_FILENO, STDOUT_FILENO);
  folder_ = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  locale_ = std::setlocale(LC_ALL, nullptr);
}

Undisturbed::~Undisturbed() {
  std::fflush(stdout);
  for (int d = 0; d < 3; ++d) {
    const int copy = streams_[static_cast<std::size_t>(d)];
    if (copy < 0) continue;
    dup2(copy, d);
    close(copy);
  }
  if (folder_ >= 0) {
    if (fchdir(folder_) != 0) std::perror("riedel: the working folder is lost");
    close(folder_);
  }
  std::setlocale(LC_ALL, locale_.c_str());
  for (int s = 1; s < signals; ++s) sigaction(s, &handlers_[static_cast<std::size_t>(s)], nullptr);
}

} // namespace riedel
