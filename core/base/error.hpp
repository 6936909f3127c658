/// Kinds of errors, by who can fix them; the program's exit code follows from the type.
#pragma once

#include <stdexcept>
#include <string>

namespace riedel {

/// The input is wrong (exit 2). The text names file, line, key, what was given and what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run failed (exit 3). The text names point, step and time.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A plug-in or something outside the program is missing (exit 4).
struct PluginError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace riedel
