#include "core/io/xml.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>

namespace riedel {

namespace {

constexpr std::string_view blank = " \t\r\n";
constexpr int deepest = 16;

class XmlReader {
public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  XmlElement document() {
    skip_to_element();
    XmlElement root = element(0);
    skip_to_element();
    if (at_ != text_.size()) fail("text after the last element");
    return root;
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(what + " at byte " + std::to_string(at_)); }
  [[nodiscard]] bool next_is(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip(std::string_view word) {
    if (!next_is(word)) fail("no '" + std::string(word) + "'");
    at_ += word.size();
  }
  void skip_blank() { at_ = std::min(text_.find_first_not_of(blank, at_), text_.size()); }
  /// Everything before `end`, which is skipped.
  std::string_view up_to(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) fail("no '" + std::string(end) + "'");
    const std::string_view before = text_.substr(at_, found - at_);
    at_ = found + end.size();
    return before;
  }

  /// Skips a declaration or a comment.
  bool skip_aside() {
    if (next_is("<?"))
      up_to("?>");
    else if (next_is("<!--"))
      up_to("-->");
    else
      return false;
    return true;
  }
  void skip_to_element() {
    do skip_blank();
    while (skip_aside());
  }

  std::string_view name() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/><\"'", at_), text_.size());
    if (end == at_) fail("no name");
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
  }

  void attributes(XmlElement& element) {
    for (skip_blank(); at_ < text_.size() && !next_is(">") && !next_is("/>"); skip_blank()) {
      const std::string_view key = name();
      skip("=");
      const bool single = next_is("'");
      skip(single ? "'" : "\"");
      element.attributes.emplace_back(key, up_to(single ? "'" : "\""));
    }
  }

  XmlElement element(int depth) {
    if (depth == deepest) fail("elements nested too deeply");
    skip("<");
    XmlElement made{.name = name(), .attributes = {}, .text = {}, .children = {}};
    attributes(made);
    if (next_is("/>")) {
      skip("/>");
      return made;
    }
    skip(">");
    content(made, depth);
    return made;
  }

  void content(XmlElement& element, int depth) {
    const std::size_t begin = at_;
    at_ = std::min(text_.find('<', at_), text_.size());
    element.text = text_.substr(begin, at_ - begin);
    while (!next_is("</")) {
      if (!skip_aside()) element.children.push_back(this->element(depth + 1));
      at_ = std::min(text_.find('<', at_), text_.size());
    }
    skip("</");
    if (name() != element.name) fail("the end tag does not match '" + std::string(element.name) + "'");
    skip_blank();
    skip(">");
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::string without_entities(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string plain;
  while (!text.empty()) {
    const auto entity = std::ranges::find_if(entities, [&](const auto& e) { return text.starts_with(e.first); });
    plain += entity == entities.end() ? text.front() : entity->second;
    text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
  }
  return plain;
}

} // namespace

std::string XmlElement::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes)
    if (key == wanted) return without_entities(value);
  return "";
}

const XmlElement& XmlElement::child(std::string_view wanted) const {
  const auto found = std::ranges::find(children, wanted, &XmlElement::name);
  if (found == children.end()) throw InputError("no " + std::string(wanted) + " in " + std::string(name));
  return *found;
}

XmlElement read_xml(std::string_view text) { return XmlReader(text).document(); }

} // namespace riedel
