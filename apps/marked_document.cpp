#include "apps/marked_document.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"

namespace riedel {

namespace {

std::string content(const std::filesystem::path& path) {
  try {
    return read_input_file(path);
  } catch (const InputError& error) { throw InputError(std::string("--document ") + error.what()); }
}

} // namespace

MarkedDocument::MarkedDocument(std::filesystem::path path, const std::string& mark) : path_(std::move(path)) {
  const std::string text = content(path_);
  std::error_code unknown;
  if (auto there = std::filesystem::canonical(path_, unknown); !unknown) path_ = std::move(there); // links stay links
  const std::string opening = "<!-- " + mark + " -->\n", closing = "<!-- " + mark + " ends -->\n";
  const std::size_t first = text.find(opening), last = text.find(closing);
  if (first == std::string::npos || last == std::string::npos || last < first)
    throw InputError("--document " + path_.string() + ": has no line " + opening.substr(0, opening.size() - 1) +
                     " with a line " + closing.substr(0, closing.size() - 1) + " below it");
  before_ = text.substr(0, first + opening.size());
  after_ = text.substr(last);
}

void MarkedDocument::write(const std::string& text) const {
  write_atomically(path_, before_ + "\n" + text + "\n" + after_);
}

} // namespace riedel
