#include "core/io/bytes/xml.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr int deepest = 100'000;

/// Takes what begins with `start` and ends with `end` off the front of `text`.
bool skip(std::string_view& text, std::string_view start, std::string_view end) {
  if (!text.starts_with(start)) return false;
  const std::size_t found = text.find(end, start.size());
  if (found == std::string_view::npos) return false;
  text.remove_prefix(found + end.size());
  return true;
}

std::string withoutControls(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c >= 0 && c < 0x20; }, ' ');
  return text;
}

} // namespace

bool isXml(std::string_view beginning, std::string_view root) {
  if (beginning.starts_with("\xEF\xBB\xBF")) beginning.remove_prefix(3);
  do {
    beginning.remove_prefix(std::min(beginning.find_first_not_of(" \t\r\n"), beginning.size()));
  } while (skip(beginning, "<?", "?>") || skip(beginning, "<!--", "-->") ||
           skip(beginning, "<!DOCTYPE", ">"));
  if (!beginning.starts_with('<')) return false;
  beginning.remove_prefix(1);
  if (!beginning.starts_with(root) || beginning.size() == root.size()) return false;
  return std::string_view(" \t\r\n/>").find(beginning[root.size()]) != std::string_view::npos;
}

XmlFile::XmlFile(std::string bytes, std::string file, std::string_view root)
    : bytes_(std::move(bytes)), file_(std::move(file)) {
  const pugi::xml_parse_result result = document_.load_buffer(
      bytes_.data(), bytes_.size(), pugi::parse_default | pugi::parse_doctype);
  if (!result)
    throw ShownError(
        {espalier::Shown::tr("the XML is broken here (%1): copy or export the file again"),
         {result.description()},
         whereByte(result.offset)});
  refuseEntities();
  refuseDeepNesting();
  if (this->root().name() != root)
    throw ShownError({espalier::Shown::tr("expected an element %1, found %2"),
                      {inQuotes(root), inQuotes(this->root().name())},
                      where(this->root())});
}

FilePlace XmlFile::where(pugi::xml_node node) const {
  return whereByte(node.offset_debug());
}

FilePlace XmlFile::whereByte(std::ptrdiff_t byte) const {
  const bool isUtf16 = bytes_.find('\0') != std::string::npos; // bytes are counted in UTF-8
  if (byte < 0 || isUtf16) return {file_};
  const auto end = bytes_.begin() + std::min(byte, std::ssize(bytes_));
  return {file_, 1 + static_cast<std::size_t>(std::count(bytes_.begin(), end, '\n'))};
}

double XmlFile::numberIn(pugi::xml_node node, std::string_view text, std::string_view what) const {
  const auto number = espalier::numberIn(trimmed(text));
  if (!number || !std::isfinite(*number))
    throw ShownError({espalier::Shown::tr("expected a number as %1, found %2"),
                      {std::string(what), inQuotes(text)},
                      where(node)});
  return *number;
}

void XmlFile::refuseEntities() const {
  for (const pugi::xml_node node : document_.children())
    if (node.type() == pugi::node_doctype &&
        std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos)
      throw ShownError(
          {espalier::Shown::tr("the document defines entities, which are not read: export it "
                               "without them"),
           {},
           where(node)});
}

void XmlFile::refuseDeepNesting() const {
  int depth = 0;
  for (pugi::xml_node node = document_.root(); node;) {
    if (node.first_child()) {
      node = node.first_child();
      if (++depth > deepest)
        throw ShownError(
            {espalier::Shown::tr("its elements are nested over %1 deep, as in no plant"),
             {std::to_string(deepest)},
             where(node)});
      continue;
    }
    while (node && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node.next_sibling();
  }
}

void addText(pugi::xml_node parent, const std::string& name, const std::string& text) {
  parent.append_child(name.c_str()).text().set(withoutControls(text).c_str());
}

void addAttribute(pugi::xml_node element, const char* name, const std::string& value) {
  element.append_attribute(name).set_value(withoutControls(value).c_str());
}

void writeXml(std::ostream& out, pugi::xml_document& document) {
  pugi::xml_node declaration = document.prepend_child(pugi::node_declaration);
  addAttribute(declaration, "version", "1.0");
  addAttribute(declaration, "encoding", "UTF-8");
  // Not indented: in a plant, elements are nested thousands deep.
  document.save(out, "", pugi::format_default & ~pugi::format_indent, pugi::encoding_utf8);
}

} // namespace espalier
