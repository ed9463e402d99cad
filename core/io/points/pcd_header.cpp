#include "core/io/points/pcd_header.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

namespace espalier {
namespace {

struct Line {
  std::vector<std::string_view> words; // after the keyword
  FilePlace where;
};

using Lines = std::map<std::string, Line, std::less<>>; // by keyword

std::uint64_t wholeNumber(std::string_view word, const FilePlace& where) {
  std::uint64_t value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || stop != end || error != std::errc{})
    throw ShownError(
        {espalier::Shown::tr("expected a whole number, found %1"), {inQuotes(word)}, where});
  return value;
}

ScalarType typeOf(char kind, std::uint64_t size, const FilePlace& where) {
  const std::string name = kind + std::to_string(size);
  static const std::map<std::string, ScalarType, std::less<>> types = {
      {"I1", ScalarType::int8},    {"U1", ScalarType::uint8},  {"I2", ScalarType::int16},
      {"U2", ScalarType::uint16},  {"I4", ScalarType::int32},  {"U4", ScalarType::uint32},
      {"I8", ScalarType::int64},   {"U8", ScalarType::uint64}, {"F4", ScalarType::float32},
      {"F8", ScalarType::float64},
  };
  const auto found = types.find(name);
  if (found == types.end())
    throw ShownError({size == 1 ? Shown::tr("a field of type %1 cannot have 1 byte")
                                : Shown::tr("a field of type %1 cannot have %2 bytes"),
                      {inQuotes(name.substr(0, 1)), std::to_string(size)},
                      where});
  return found->second;
}

const Line& required(const Lines& lines, std::string_view keyword, const std::string& file) {
  const auto found = lines.find(keyword);
  if (found == lines.end())
    throw ShownError(
        {Shown::tr("its header has no line %1"), {std::string(keyword)}, FilePlace{file}});
  return found->second;
}

/// The line `keyword` if there is one; it must have a word per field.
const Line* perField(const Lines& lines, std::string_view keyword, std::size_t fields) {
  const auto found = lines.find(keyword);
  if (found == lines.end()) return nullptr;
  if (found->second.words.size() != fields)
    throw ShownError({Shown::tr("expected %1 values, one per field, found %2"),
                      {std::to_string(fields), std::to_string(found->second.words.size())},
                      found->second.where});
  return &found->second;
}

std::vector<PcdField> fieldsOf(const Lines& lines, const std::string& file) {
  const Line& names = required(lines, "FIELDS", file);
  required(lines, "SIZE", file);
  required(lines, "TYPE", file);
  const Line& sizes = *perField(lines, "SIZE", names.words.size());
  const Line& types = *perField(lines, "TYPE", names.words.size());
  const Line* counts = perField(lines, "COUNT", names.words.size());
  std::vector<PcdField> fields;
  for (std::size_t i = 0; i < names.words.size(); ++i) {
    PcdField field{.name = std::string(names.words[i])};
    field.type =
        typeOf(types.words[i].front(), wholeNumber(sizes.words[i], sizes.where), types.where);
    if (counts != nullptr) {
      const std::uint64_t count = wholeNumber(counts->words[i], counts->where);
      constexpr std::uint64_t most = 1 << 20; // descriptors have hundreds
      if (count > most)
        throw ShownError(
            {Shown::tr("a field cannot have %1 values"), {std::to_string(count)}, counts->where});
      field.count = static_cast<std::uint32_t>(count);
    }
    fields.push_back(field);
  }
  return fields;
}

std::uint64_t pointCount(const Lines& lines, const std::string& file) {
  const auto number = [&](std::string_view keyword) {
    const Line& line = required(lines, keyword, file);
    if (line.words.empty())
      throw ShownError({espalier::Shown::tr("expected a whole number"), {}, line.where});
    return wholeNumber(line.words.front(), line.where);
  };
  if (lines.contains("POINTS")) return number("POINTS");
  const std::uint64_t width = number("WIDTH");
  const std::uint64_t height = number("HEIGHT");
  if (height != 0 && width > UINT64_MAX / height)
    throw ShownError({espalier::Shown::tr("WIDTH times HEIGHT is beyond any file"),
                      {},
                      required(lines, "WIDTH", file).where});
  return width * height;
}

PcdData dataOf(const Line& line) {
  const std::string_view kind = line.words.empty() ? std::string_view() : line.words.front();
  if (kind == "ascii") return PcdData::ascii;
  if (kind == "binary") return PcdData::binary;
  if (kind == "binary_compressed") return PcdData::compressed;
  throw ShownError(
      {Shown::tr("data of kind %1 is unknown: expected ascii, binary or binary_compressed"),
       {inQuotes(kind)},
       line.where});
}

} // namespace

std::uint64_t PcdHeader::pointSize() const {
  std::uint64_t size = 0;
  for (const PcdField& field : fields)
    size += field.size();
  return size;
}

PcdHeader readPcdHeader(std::string_view bytes, const std::string& file) {
  LineReader reader(bytes);
  Lines lines;
  while (const auto text = reader.next()) {
    std::string_view rest = *text;
    const std::string_view keyword = nextWord(rest);
    if (keyword.empty() || keyword.starts_with('#')) continue;
    Line& line = lines[std::string(keyword)];
    line.where = {file, reader.number()};
    line.words.clear();
    for (auto word = nextWord(rest); !word.empty(); word = nextWord(rest))
      line.words.push_back(word);
    if (keyword != "DATA") continue;
    PcdHeader header;
    header.fields = fieldsOf(lines, file);
    header.points = pointCount(lines, file);
    header.data = dataOf(line);
    header.dataStart = reader.offset();
    header.lines = reader.number();
    return header;
  }
  throw ShownError({Shown::tr("its header has no line DATA: it is no PCD file, or is cut short"),
                    {},
                    FilePlace{file}});
}

} // namespace espalier
