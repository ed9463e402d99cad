#pragma once

#include "core/base/shown_message.h"

#include <iosfwd>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is XML whose outermost element has this name.
[[nodiscard]] bool isXml(std::string_view beginning, std::string_view root);

/// An XML document, and where in its file each element stands.
///
/// Of hostile files: entities are never expanded, and a document that defines some is refused, as
/// is one of elements nested over 100 000 deep; nothing is loaded from elsewhere.
class XmlFile {
public:
  /// @throws Error naming the line where the document is broken, or if its outermost element has
  ///         another name
  XmlFile(std::string bytes, std::string file, std::string_view root);

  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// The line, for messages. Time O(size of the file).
  [[nodiscard]] FilePlace where(pugi::xml_node node) const;

  /// The finite number that `text` is.
  /// @param what  for the message: "x"
  /// @throws Error naming the line of `node` if it is none
  [[nodiscard]] double numberIn(pugi::xml_node node, std::string_view text,
                                std::string_view what) const;

private:
  [[nodiscard]] FilePlace whereByte(std::ptrdiff_t byte) const;
  void refuseEntities() const;
  void refuseDeepNesting() const;

  std::string bytes_;
  std::string file_;
  pugi::xml_document document_;
};

/// Adds an element `name` of this text, with blanks for the control characters, which XML cannot
/// hold.
void addText(pugi::xml_node parent, const std::string& name, const std::string& text);

void addAttribute(pugi::xml_node element, const char* name, const std::string& value);

/// Writes a document in UTF-8, an element a line.
void writeXml(std::ostream& out, pugi::xml_document& document);

} // namespace espalier
