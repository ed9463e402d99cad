#include "core/io/points/ply_header.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace espalier {
namespace {

using NamedType = std::pair<std::string_view, ScalarType>;

constexpr auto namedTypes =
    std::to_array<NamedType>({{"char", ScalarType::int8},      {"int8", ScalarType::int8},
                              {"uchar", ScalarType::uint8},    {"uint8", ScalarType::uint8},
                              {"short", ScalarType::int16},    {"int16", ScalarType::int16},
                              {"ushort", ScalarType::uint16},  {"uint16", ScalarType::uint16},
                              {"int", ScalarType::int32},      {"int32", ScalarType::int32},
                              {"uint", ScalarType::uint32},    {"uint32", ScalarType::uint32},
                              {"long", ScalarType::int64},     {"int64", ScalarType::int64},
                              {"ulong", ScalarType::uint64},   {"uint64", ScalarType::uint64},
                              {"float", ScalarType::float32},  {"float32", ScalarType::float32},
                              {"double", ScalarType::float64}, {"float64", ScalarType::float64}});

ScalarType typeNamed(std::string_view name, const FilePlace& where) {
  const auto* found = std::ranges::find(namedTypes, name, &NamedType::first);
  if (found == namedTypes.end())
    throw ShownError({Shown::tr("%1 is no type of PLY: expected one as 'float' or 'uchar'"),
                      {inQuotes(name)},
                      where});
  return found->second;
}

void readFormat(std::string_view rest, PlyHeader& header, const FilePlace& where) {
  const std::string_view format = nextWord(rest);
  if (format == "binary_big_endian")
    header.order = std::endian::big;
  else if (format != "binary_little_endian" && format != "ascii")
    throw ShownError(
        {Shown::tr(
             "the format %1 is unknown: expected ascii, binary_little_endian or binary_big_endian"),
         {inQuotes(format)},
         where});
  header.isAscii = format == "ascii";
}

PlyElement elementOf(std::string_view rest, const FilePlace& where) {
  PlyElement element;
  element.name = nextWord(rest);
  const std::string_view count = nextWord(rest);
  const char* end = count.data() + count.size();
  const auto [stop, error] = std::from_chars(count.data(), end, element.count);
  if (count.empty() || stop != end || error != std::errc{})
    throw ShownError(
        {Shown::tr("expected a name and a count after 'element', found %1 for the count"),
         {inQuotes(count)},
         where});
  return element;
}

PlyProperty propertyOf(std::string_view rest, const FilePlace& where) {
  PlyProperty property;
  std::string_view type = nextWord(rest);
  if (type == "list") {
    property.countType = typeNamed(nextWord(rest), where);
    if (isFloat(*property.countType))
      throw ShownError({Shown::tr("the length of a list must be of an integer type"), {}, where});
    type = nextWord(rest);
  }
  property.type = typeNamed(type, where);
  property.name = nextWord(rest);
  if (property.name.empty()) throw ShownError({Shown::tr("a property has no name"), {}, where});
  return property;
}

} // namespace

bool PlyElement::hasLists() const {
  return std::ranges::any_of(properties,
                             [](const PlyProperty& p) { return p.countType.has_value(); });
}

std::uint64_t PlyElement::leastSize() const {
  std::uint64_t size = 0;
  for (const PlyProperty& property : properties)
    size += sizeOf(property.countType.value_or(property.type));
  return size;
}

PlyHeader readPlyHeader(std::string_view bytes, const std::string& file) {
  LineReader lines(bytes);
  const auto first = lines.next();
  if (!first || trimmed(*first) != "ply")
    throw ShownError(
        {Shown::tr("is no PLY file, its first line is not 'ply'"), {}, FilePlace{file}});
  PlyHeader header;
  bool hasFormat = false;
  while (const auto line = lines.next()) {
    const FilePlace where{file, lines.number()};
    std::string_view rest = *line;
    const std::string_view keyword = nextWord(rest);
    if (keyword == "format") {
      readFormat(rest, header, where);
      hasFormat = true;
    } else if (keyword == "element") {
      header.elements.push_back(elementOf(rest, where));
    } else if (keyword == "property") {
      if (header.elements.empty())
        throw ShownError({Shown::tr("a property stands before any element"), {}, where});
      header.elements.back().properties.push_back(propertyOf(rest, where));
    } else if (keyword == "end_header") {
      if (!hasFormat) throw ShownError({Shown::tr("the header has no line 'format'"), {}, where});
      header.dataStart = lines.offset();
      header.lines = lines.number();
      return header;
    } else if (keyword == "comment") {
      header.comments.push_back(trimmed(rest));
    } else if (!keyword.empty() && keyword != "obj_info") {
      throw ShownError(
          {Shown::tr("%1 is unknown in the header of a PLY file"), {inQuotes(keyword)}, where});
    }
  }
  throw ShownError({Shown::tr("has no line 'end_header': it is cut short, copy or export it again"),
                    {},
                    FilePlace{file}});
}

} // namespace espalier
