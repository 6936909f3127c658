#include "core/io/messages.hpp"

#include "core/io/readable.hpp"

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace riedel {

namespace {

bool in_colour() {
  const char* refused = std::getenv("NO_COLOR"); // any non-empty text: https://no-color.org
  return ::isatty(STDERR_FILENO) == 1 && (refused == nullptr || *refused == '\0');
}

void print(std::string_view kind, std::string_view colour, std::string_view text) {
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::cerr << "riedel: ";
    if (in_colour())
      std::cerr << "\033[" << colour << "m" << kind << ":\033[0m ";
    else
      std::cerr << kind << ": ";
    std::cerr << readable(line) << '\n'; // input may contain control characters for a terminal
  }
}

} // namespace

void print_error(std::string_view text) { print("error", "1;31", text); }
void print_warning(std::string_view text) { print("warning", "1;33", text); }
void print_note(std::string_view text) { print("note", "1;36", text); }

} // namespace riedel
