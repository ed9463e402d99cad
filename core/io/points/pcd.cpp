#include "core/io/points/pcd.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/bytes/byte_stream.h"
#include "core/io/bytes/line_stream.h"
#include "core/io/points/lzf.h"
#include "core/io/points/pcd_header.h"
#include "core/io/points/point_collector.h"

#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// A field that is wanted, and where it lies.
struct Column {
  PointField role = PointField::none;
  ScalarType type = ScalarType::float32;
  std::size_t value = 0;  // number of its first value in a line of text
  std::size_t start = 0;  // in bytes: of the first point
  std::size_t stride = 0; // in bytes: to the next point, if all are there; 0: they come by and by
};

/// A color is packed into the bits of a float, or is an integer.
double packedColor(double value, ScalarType type) {
  if (type != ScalarType::float32) return value;
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

std::vector<PointField> rolesOf(const PcdHeader& header, const std::string& file) {
  std::vector<PointField> roles;
  std::array<bool, PointValues().size()> taken{};
  for (const PcdField& field : header.fields) {
    const PointField role = field.count > 0 ? pointFieldNamed(field.name) : PointField::none;
    roles.push_back(std::exchange(taken[indexOf(role)], true) ? PointField::none : role);
  }
  for (const auto& [role, name] : {std::pair{PointField::x, "x"}, std::pair{PointField::y, "y"},
                                   std::pair{PointField::z, "z"}})
    if (!taken[indexOf(role)])
      throw ShownError(
          {Shown::tr("has no field '%1': export it with x, y and z"), {name}, FilePlace{file}});
  return roles;
}

/// Where the wanted fields lie. Unpacked compressed data has all values of a field together, other
/// data all fields of a point.
std::vector<Column> columnsOf(const PcdHeader& header, const std::vector<PointField>& roles) {
  std::vector<Column> columns;
  std::size_t start = 0;
  std::size_t value = 0;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const PcdField& field = header.fields[i];
    const bool byField = header.data == PcdData::compressed;
    if (roles[i] != PointField::none)
      columns.push_back({roles[i], field.type, value, start, byField ? field.size() : 0});
    start += field.size() * (byField ? header.points : 1);
    value += field.count;
  }
  return columns;
}

ShownError noNumber(std::string_view word, const Column& column, const FilePlace& where) {
  const std::string value = std::to_string(column.value + 1);
  if (word.empty())
    return ShownError(
        {Shown::tr("expected a number as value %1, found the end of the line"), {value}, where});
  return ShownError(
      {Shown::tr("expected a number as value %1, found %2"), {value, inQuotes(word)}, where});
}

void readAscii(LineStream lines, const PcdHeader& header, const std::vector<Column>& columns,
               const std::string& file, PointCollector& points, const Progress& progress) {
  PointValues values{};
  for (std::uint64_t row = 0; row < header.points;) {
    const auto line = lines.next();
    if (!line)
      throw ShownError(
          {Shown::tr("ends after %1 of %2 points: it is cut short, copy or export it again"),
           {std::to_string(row), std::to_string(header.points)},
           FilePlace{file}});
    std::string_view rest = *line;
    if (trimmed(rest).empty()) continue;
    if (row++ % 65536 == 0)
      progress.update(static_cast<double>(lines.offset()) / static_cast<double>(lines.size()));
    std::size_t read = 0;
    for (const Column& column : columns) {
      std::string_view word;
      for (; read <= column.value; ++read)
        word = nextWord(rest);
      const auto number = numberIn(word);
      if (!number) throw noNumber(word, column, {file, header.lines + lines.number()});
      values[indexOf(column.role)] =
          column.role == PointField::packedColor ? packedColor(*number, column.type) : *number;
    }
    points.add(values);
  }
}

/// @param pointAt  gives the bytes of a point, from where the starts of columns count
template <class PointAt>
void readBinary(const PointAt& pointAt, const PcdHeader& header, const std::vector<Column>& columns,
                PointCollector& points, const Progress& progress) {
  PointValues values{};
  for (std::uint64_t i = 0; i < header.points; ++i) {
    if (i % 65536 == 0)
      progress.update(static_cast<double>(i) / static_cast<double>(header.points));
    const char* bytes = pointAt();
    for (const Column& column : columns) {
      const char* at = bytes + column.start + i * column.stride;
      // A float that holds a color is never read as a number: a signaling NaN would lose a bit.
      const bool isPacked = column.role == PointField::packedColor && sizeOf(column.type) == 4;
      values[indexOf(column.role)] =
          isPacked ? valueAt<std::uint32_t>(at) : scalarAt(at, column.type);
    }
    points.add(values);
  }
}

/// Checks what compressed data would fill before memory is taken for it: packed as tightly as no
/// scan can be, a file of 1 MB would fill gigabytes.
void refuseBomb(const std::string& file, const PcdHeader& header, std::uint64_t packed,
                std::uint64_t unpacked) {
  constexpr std::uint64_t freeBytes = 1 << 26;
  constexpr std::uint64_t mostBytes = 32; // to a packed byte
  constexpr std::uint64_t freePoints = 1 << 20;
  constexpr std::uint64_t mostPoints = 4; // to a packed byte
  if (unpacked <= freeBytes + mostBytes * packed &&
      header.points <= freePoints + mostPoints * packed)
    return;
  throw ShownError(
      {Shown::tr("its %1 bytes of compressed data would unpack to %2 bytes of %3 points, as of no "
                 "scan: export it again, not compressed"),
       {std::to_string(packed), std::to_string(unpacked), std::to_string(header.points)},
       FilePlace{file}});
}

/// The data of a compressed file, unpacked: all values of the first field, then of the second ...
std::string unpacked(std::string_view data, const PcdHeader& header, const std::string& file) {
  constexpr std::size_t sizes = 8; // two sizes of 32 bits come first
  if (data.size() < sizes)
    throw ShownError(
        {espalier::Shown::tr("ends before its data: it is cut short"), {}, FilePlace{file}});
  const auto packedSize = valueAt<std::uint32_t>(data.data());
  const auto size = valueAt<std::uint32_t>(data.data() + 4);
  checkPromise(FilePlace{file}, header.points, header.pointSize(), size);
  refuseBomb(file, header, packedSize, size);
  if (packedSize > data.size() - sizes)
    throw ShownError(
        {espalier::Shown::tr("its header promises %1 bytes of compressed data, but only %2 "
                             "follow: the file is cut short, copy or export it again"),
         {std::to_string(packedSize), std::to_string(data.size() - sizes)},
         FilePlace{file}});
  auto bytes = unpackedLzf(data.substr(sizes, packedSize), size);
  if (!bytes)
    throw ShownError(
        {espalier::Shown::tr("its compressed data is damaged: copy or export it again"),
         {},
         FilePlace{file}});
  return *std::move(bytes);
}

} // namespace

bool isPcd(std::string_view beginning) {
  if (beginning.starts_with("# .PCD")) return true;
  LineReader lines(beginning);
  while (const auto line = lines.next()) {
    if (line->starts_with('#') || trimmed(*line).empty()) continue;
    return (line->starts_with("VERSION") || line->starts_with("FIELDS ")) &&
           beginning.find("\nDATA ") != std::string_view::npos;
  }
  return false;
}

ImportedPoints readPcd(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  constexpr std::uint64_t longestHeader = std::uint64_t{1} << 24;
  ByteSource source(in);
  const PcdHeader header = readPcdHeader(source.read(0, longestHeader), file);
  const std::vector<PointField> roles = rolesOf(header, file);
  const std::vector<Column> columns = columnsOf(header, roles);
  PartChooser chooser(options);
  const auto collector = [&](std::uint64_t pointSize, std::uint64_t available) {
    checkPromise(FilePlace{file}, header.points, pointSize, available);
    return PointCollector(roles, header.points, chooser);
  };
  const auto finished = [&](PointCollector points) {
    return ImportedPoints{{std::move(points).finish(true), {}}, header.points};
  };
  const std::uint64_t size = source.size() - header.dataStart;
  if (header.data == PcdData::ascii) {
    PointCollector points = collector(5, size); // "0 0 0"
    readAscii(LineStream(source, header.dataStart), header, columns, file, points, progress);
    return finished(std::move(points));
  }
  if (header.data == PcdData::compressed) { // each field by itself: there is no reading in pieces
    const std::string room = unpacked(source.read(header.dataStart, size), header, file);
    PointCollector points = collector(header.pointSize(), room.size());
    readBinary([&] { return room.data(); }, header, columns, points, progress.part(0.3, 1));
    return finished(std::move(points));
  }
  PointCollector points = collector(header.pointSize(), size);
  ByteStream bytes(source, header.dataStart);
  const auto next = [&] {
    const char* point = bytes.take(header.pointSize());
    if (point == nullptr) throw becameShorter(file);
    return point;
  };
  readBinary(next, header, columns, points, progress);
  return finished(std::move(points));
}

} // namespace espalier
