#include "apps/verify/document.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"

#include <fstream>
#include <sstream>

namespace riedel {

namespace {

constexpr std::string_view opening = "<!-- riedel verify -->\n", closing = "<!-- riedel verify ends -->\n";

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError("--document " + path.string() + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

VerifyDocument::VerifyDocument(std::filesystem::path path) : path_(std::move(path)) {
  const std::string text = content(path_);
  const std::size_t first = text.find(opening), last = text.find(closing);
  if (first == std::string::npos || last == std::string::npos || last < first)
    throw InputError("--document " + path_.string() + ": has no line " + std::string(opening, 0, opening.size() - 1) +
                     " with a line " + std::string(closing, 0, closing.size() - 1) + " below it");
  before_ = text.substr(0, first + opening.size());
  after_ = text.substr(last);
}

void VerifyDocument::write(const std::string& tables) const {
  write_atomically(path_, before_ + "\n" + tables + "\n" + after_);
}

} // namespace riedel
