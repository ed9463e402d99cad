#include "core/io/points/las.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/bytes/scalar.h"
#include "core/io/points/point_collector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t smallestHeader = 227; // of versions 1.0 to 1.2
constexpr std::size_t formatOffset = 104;
constexpr std::uint8_t compressedBits = 0xc0; // set by LASzip in the point format

struct PointFormat {
  std::uint16_t length;     // bytes of a record without extra bytes
  std::uint16_t colorStart; // where red, green and blue lie; 0: nowhere
};

constexpr std::array<PointFormat, 11> pointFormats = {{{20, 0},
                                                       {28, 0},
                                                       {26, 20},
                                                       {34, 28},
                                                       {57, 0},
                                                       {63, 28},
                                                       {30, 0},
                                                       {36, 30},
                                                       {38, 30},
                                                       {59, 0},
                                                       {67, 30}}};

struct Header {
  int minorVersion = 0;
  std::uint64_t pointStart = 0;
  std::size_t format = 0;
  std::size_t recordLength = 0;
  std::uint64_t count = 0;
  Eigen::Vector3d scale;
  Eigen::Vector3d offset;
};

Eigen::Vector3d vectorAt(const char* bytes) {
  return {valueAt<double>(bytes), valueAt<double>(bytes + 8), valueAt<double>(bytes + 16)};
}

std::uint64_t pointCount(std::string_view bytes, int minorVersion) {
  const std::uint64_t legacy = valueAt<std::uint32_t>(bytes.data() + 107);
  constexpr std::size_t countEnd = 255; // of the 64 bit count of version 1.4
  if (minorVersion < 4 || bytes.size() < countEnd) return legacy;
  const auto count = valueAt<std::uint64_t>(bytes.data() + 247);
  return count != 0 ? count : legacy;
}

void check(const Header& header, std::string_view bytes, const std::string& file) {
  if (header.format >= pointFormats.size())
    throw Error(file + ": has points of format " + std::to_string(header.format) +
                ", which LAS 1.4 does not define: convert it to one of 0 to 10");
  if (header.recordLength < pointFormats[header.format].length)
    throw Error(file + ": says its points of format " + std::to_string(header.format) + " have " +
                std::to_string(header.recordLength) + " bytes, fewer than the " +
                std::to_string(pointFormats[header.format].length) +
                " of this format: the header is damaged, export it again");
  if (header.pointStart < smallestHeader || header.pointStart > bytes.size())
    throw Error(file + ": says its points start at byte " + std::to_string(header.pointStart) +
                " of " + std::to_string(bytes.size()) +
                ": the file is cut short or damaged, copy or export it again");
  checkPromise(file, header.count, header.recordLength, bytes.size() - header.pointStart);
}

Header readHeader(std::string_view bytes, const std::string& file) {
  if (!isLas(bytes)) throw Error(file + ": is no LAS file, it does not begin with LASF");
  if (bytes.size() < smallestHeader)
    throw Error(file + ": ends within its header: the file is cut short, copy or export it again");
  if (isLaz(bytes))
    throw Error(file + ": is a compressed LAS file (LAZ): unpack it first, as by 'laszip -i " +
                file + " -o unpacked.las' or 'pdal translate " + file + " unpacked.las'");
  const int major = valueAt<std::uint8_t>(bytes.data() + 24);
  const int minor = valueAt<std::uint8_t>(bytes.data() + 25);
  if (major != 1 || minor > 4)
    throw Error(file + ": is LAS " + std::to_string(major) + "." + std::to_string(minor) +
                ", and versions 1.0 to 1.4 can be read: convert it to 1.4");
  Header header;
  header.minorVersion = minor;
  header.pointStart = valueAt<std::uint32_t>(bytes.data() + 96);
  header.format = valueAt<std::uint8_t>(bytes.data() + formatOffset);
  header.recordLength = valueAt<std::uint16_t>(bytes.data() + 105);
  header.count = pointCount(bytes, minor);
  header.scale = vectorAt(bytes.data() + 131);
  header.offset = vectorAt(bytes.data() + 155);
  check(header, bytes, file);
  return header;
}

std::vector<PointField> fieldsOf(const Header& header) {
  using enum PointField;
  if (pointFormats[header.format].colorStart > 0) return {intensity, red, green, blue};
  return {intensity};
}

bool isWithheld(const char* record, const Header& header) {
  if (header.format >= 6) return (valueAt<std::uint8_t>(record + 15) & 0x04) != 0;
  // The flag took its bit from the class in version 1.1.
  return header.minorVersion > 0 && (valueAt<std::uint8_t>(record + 15) & 0x80) != 0;
}

PointValues valuesOf(const char* record, const Header& header) {
  PointValues values{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    values[indexOf(PointField::x) + axis] =
        valueAt<std::int32_t>(record + 4 * axis) * header.scale[i] + header.offset[i];
  }
  values[indexOf(PointField::intensity)] = valueAt<std::uint16_t>(record + 12);
  const std::size_t colorStart = pointFormats[header.format].colorStart;
  if (colorStart > 0)
    for (std::size_t i = 0; i < 3; ++i)
      values[indexOf(PointField::red) + i] = valueAt<std::uint16_t>(record + colorStart + 2 * i);
  return values;
}

/// Scanners without a camera or a radiometer fill in zeros.
void dropEmptyColumns(RawPoints& points) {
  if (std::ranges::all_of(points.intensities, [](float value) { return value == 0; }))
    points.intensities.clear();
  if (std::ranges::all_of(points.colors, [](const Color& color) { return color == Color{}; }))
    points.colors.clear();
}

} // namespace

bool isLas(std::string_view beginning) {
  return beginning.starts_with("LASF");
}

bool isLaz(std::string_view beginning) {
  return isLas(beginning) && beginning.size() > formatOffset &&
         (static_cast<std::uint8_t>(beginning[formatOffset]) & compressedBits) != 0;
}

Imported<RawPoints> readLas(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string bytes = readAll(in, progress.part(0, 0.3));
  const Header header = readHeader(bytes, file);
  PointCollector points(fieldsOf(header), header.count);
  std::uint64_t withheld = 0;
  const char* record = bytes.data() + header.pointStart;
  for (std::uint64_t i = 0; i < header.count; ++i, record += header.recordLength) {
    if (i % 65536 == 0)
      progress.update(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(header.count));
    if (isWithheld(record, header))
      ++withheld;
    else
      points.add(valuesOf(record, header));
  }
  Imported<RawPoints> result{std::move(points).finish(false), {}};
  dropEmptyColumns(result.value);
  if (withheld > 0)
    result.notes.push_back(file + ": " + std::to_string(withheld) + " of " +
                           std::to_string(header.count) +
                           " points are flagged as withheld and are left out");
  return result;
}

} // namespace espalier
