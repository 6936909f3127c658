/// Common functions for the readers under test.
#pragma once

#include "core/base/error.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace riedel::fuzz {

/// Runs code that may refuse its input; a refusal must have a message.
template <class Read>
void may_refuse(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    if (std::string_view(error.what()).empty()) throw std::logic_error("a refusal without a word");
  }
}

/// @throws std::logic_error: a property that every input has to keep is broken
void require(bool holds, const char* what);

/// A folder of this process for inputs that are read from files; it is removed when the process ends.
class Folder {
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file and returns its path.
  std::filesystem::path file(const std::filesystem::path& name, std::string_view bytes) const;

private:
  std::filesystem::path path_;
};

/// The parts of an input between lines "----"; as many as requested, the last ones empty if necessary.
std::vector<std::string_view> parts(std::string_view input, std::size_t count);

} // namespace riedel::fuzz
