#include "core/io/marked_document.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"

#include <algorithm>
#include <optional>

namespace riedel {

namespace {

std::string content(const std::filesystem::path& path) {
  try {
    return read_input_file(path);
  } catch (const InputError& error) { throw InputError(std::string("--document ") + error.what()); }
}

struct Span {
  std::size_t begin, end; ///< including its line break
};

/// The first line from `start` on that consists of this text only, with any kind of line break.
std::optional<Span> find_line(const std::string& text, const std::string& line, std::size_t start) {
  for (std::size_t at = text.find(line, start); at != std::string::npos; at = text.find(line, at + 1)) {
    std::size_t end = at + line.size();
    if (end < text.size() && text[end] == '\r') ++end;
    if ((at == 0 || text[at - 1] == '\n') && (end == text.size() || text[end] == '\n'))
      return Span{at, std::min(end + 1, text.size())};
  }
  return std::nullopt;
}

} // namespace

MarkedDocument::MarkedDocument(std::filesystem::path path, const std::string& mark) : path_(std::move(path)) {
  const std::string text = content(path_), opening = "<!-- " + mark + " -->", closing = "<!-- " + mark + " ends -->";
  std::error_code unknown;
  if (auto there = std::filesystem::canonical(path_, unknown); !unknown) path_ = std::move(there); // keeps links
  const auto first = find_line(text, opening, 0);
  const auto last = first ? find_line(text, closing, first->end) : std::nullopt;
  if (!last)
    throw InputError("--document " + path_.string() + ": has no line " + opening + " with a line " + closing +
                     " below it");
  before_ = text.substr(0, first->end);
  after_ = text.substr(last->begin);
}

void MarkedDocument::write(const std::string& text) const {
  write_atomically(path_, before_ + "\n" + text + "\n" + after_);
}

} // namespace riedel
