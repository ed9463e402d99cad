#include "core/io/points/las_header.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"

#include <algorithm>
#include <array>

namespace espalier {
namespace {

constexpr std::size_t smallestHeader = 227; // of versions 1.0 to 1.2
constexpr std::size_t formatOffset = 104;
constexpr std::uint8_t compressedBits = 0xc0; // set by LASzip in the point format

struct PointFormat {
  std::uint16_t length;     // bytes of a point without extra bytes
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

void check(const LasHeader& header, std::uint64_t fileSize, const std::string& file) {
  if (header.format >= pointFormats.size())
    throw ShownError({Shown::tr("has points of format %1, which LAS 1.4 does not define: convert "
                                "it to one of 0 to 10"),
                      {std::to_string(header.format)},
                      FilePlace{file}});
  if (header.pointLength < pointFormats[header.format].length)
    throw ShownError({Shown::tr("says its points of format %1 have %2 bytes, fewer than the %3 of "
                                "this format: the header is damaged, export it again"),
                      {std::to_string(header.format), std::to_string(header.pointLength),
                       std::to_string(pointFormats[header.format].length)},
                      FilePlace{file}});
  if (header.pointStart < smallestHeader || header.pointStart > fileSize)
    throw ShownError({Shown::tr("says its points start at byte %1 of %2: the file is cut short or "
                                "damaged, copy or export it again"),
                      {std::to_string(header.pointStart), std::to_string(fileSize)},
                      FilePlace{file}});
}

} // namespace

bool isLas(std::string_view beginning) {
  return beginning.starts_with("LASF");
}

bool isLaz(std::string_view beginning) {
  return isLas(beginning) && beginning.size() > formatOffset &&
         (static_cast<std::uint8_t>(beginning[formatOffset]) & compressedBits) != 0;
}

std::size_t LasHeader::colorStart() const {
  return pointFormats[format].colorStart;
}

LasHeader readLasHeader(std::string_view bytes, const std::string& file) {
  return readLasHeader(bytes, bytes.size(), file);
}

LasHeader readLasHeader(std::string_view bytes, std::uint64_t fileSize, const std::string& file) {
  if (!isLas(bytes))
    throw ShownError(
        {Shown::tr("is no LAS file, it does not begin with LASF"), {}, FilePlace{file}});
  if (bytes.size() < smallestHeader)
    throw ShownError(
        {Shown::tr("ends within its header: the file is cut short, copy or export it again"),
         {},
         FilePlace{file}});
  const int major = valueAt<std::uint8_t>(bytes.data() + 24);
  const int minor = valueAt<std::uint8_t>(bytes.data() + 25);
  if (major != 1 || minor > 4)
    throw ShownError(
        {Shown::tr("is LAS %1, and versions 1.0 to 1.4 can be read: convert it to 1.4"),
         {std::to_string(major) + '.' + std::to_string(minor)},
         FilePlace{file}});
  LasHeader header;
  header.minorVersion = minor;
  header.size = valueAt<std::uint16_t>(bytes.data() + 94);
  header.pointStart = valueAt<std::uint32_t>(bytes.data() + 96);
  header.recordCount = valueAt<std::uint32_t>(bytes.data() + 100);
  header.format = valueAt<std::uint8_t>(bytes.data() + formatOffset) & ~std::size_t{compressedBits};
  header.pointLength = valueAt<std::uint16_t>(bytes.data() + 105);
  header.count = pointCount(bytes, minor);
  header.scale = vectorAt(bytes.data() + 131);
  header.offset = vectorAt(bytes.data() + 155);
  check(header, fileSize, file);
  return header;
}

std::string_view lasRecord(std::string_view head, const LasHeader& header, std::string_view owner,
                           std::uint16_t number) {
  constexpr std::size_t lasRecordHeader = 54;
  std::string_view rest = head.substr(std::min<std::size_t>(header.size, head.size()));
  for (std::uint32_t i = 0; i < header.recordCount && rest.size() >= lasRecordHeader; ++i) {
    const bool isIt =
        rest.substr(2, 16).starts_with(owner) && valueAt<std::uint16_t>(rest.data() + 18) == number;
    const std::size_t size = valueAt<std::uint16_t>(rest.data() + 20);
    rest.remove_prefix(lasRecordHeader);
    if (isIt) return rest.substr(0, size);
    rest.remove_prefix(std::min(size, rest.size()));
  }
  return {};
}

} // namespace espalier
