/// XML as written by VTK: elements, attributes and text. No document types, and only the five entities of XML.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace riedel {

/// Views into the text that was read.
struct XmlElement {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes; ///< as written, including entities
  std::string_view text;                                                 ///< up to the first child
  std::vector<XmlElement> children;

  /// Empty if there is none.
  [[nodiscard]] std::string attribute(std::string_view name) const;
  /// The first child of that name. @throws InputError if there is none
  [[nodiscard]] const XmlElement& child(std::string_view name) const;
};

/// The outermost element. @throws InputError that says what is wrong, and at which byte
XmlElement read_xml(std::string_view text);

} // namespace riedel
