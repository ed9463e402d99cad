#include "core/io/points/e57_pages.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"
#include "core/io/points/point_collector.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace espalier {
namespace {

constexpr std::string_view e57Signature = "ASTM-E57";
constexpr std::size_t e57HeaderSize = 48;
constexpr std::size_t pageSize = 1024;
constexpr std::size_t pageContent = pageSize - 4;

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

/// What a byte adds to a CRC-32C, by how many bytes follow it among eight.
constexpr CrcTables crcTables = [] {
  constexpr std::uint32_t polynomial = 0x82f63b78; // of Castagnoli, its lowest power first
  CrcTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? polynomial : 0);
    tables[0][byte] = crc;
  }
  for (std::size_t after = 1; after < tables.size(); ++after)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[after - 1][byte];
      tables[after][byte] = (before >> 8) ^ tables[0][before & 255];
    }
  return tables;
}();

/// The CRC-32C of the content of a page, eight bytes at a time and then the last four.
std::uint32_t checksumOf(const char* content) {
  static_assert(pageContent % 8 == 4);
  std::uint32_t crc = ~std::uint32_t{0};
  const auto sum = [](std::uint32_t four, std::size_t after) {
    return crcTables[after + 3][four & 255] ^ crcTables[after + 2][four >> 8 & 255] ^
           crcTables[after + 1][four >> 16 & 255] ^ crcTables[after][four >> 24];
  };
  std::size_t at = 0;
  for (; at + 8 <= pageContent; at += 8)
    crc = sum(valueAt<std::uint32_t>(content + at) ^ crc, 4) ^
          sum(valueAt<std::uint32_t>(content + at + 4), 0);
  return ~sum(valueAt<std::uint32_t>(content + at) ^ crc, 0);
}

/// Checks whole pages, and leaves their content without the checksums.
/// @param first  the number of the first of them, of `all`, from 0
void takeChecksums(std::string& pages, std::size_t first, std::uint64_t all,
                   const std::string& file, const Progress& progress) {
  const std::size_t count = pages.size() / pageSize;
  char* const bytes = pages.data();
  for (std::size_t page = 0; page < count; ++page) {
    if (page % 1024 == 0) progress.update(static_cast<double>(page) / static_cast<double>(count));
    const char* const start = bytes + page * pageSize;
    // Unlike all else in the file, its first byte is the highest.
    if (checksumOf(start) != valueAt<std::uint32_t>(start + pageContent, std::endian::big))
      throw ShownError({Shown::tr("page %1 of %2 does not fit its checksum: the file is damaged, "
                                  "copy or export it again"),
                        {std::to_string(first + page + 1), std::to_string(all)},
                        FilePlace{.file = file, .byte = (first + page) * pageSize}});
    std::memmove(bytes + page * pageContent, start, pageContent);
  }
  pages.resize(count * pageContent);
}

} // namespace

E57Header readE57Header(std::string_view bytes, std::uint64_t fileSize, const std::string& file) {
  if (!bytes.starts_with(e57Signature))
    throw ShownError({Shown::tr("is no E57 file, it does not begin with %1"),
                      {std::string(e57Signature)},
                      FilePlace{file}});
  if (bytes.size() < e57HeaderSize)
    throw ShownError(
        {Shown::tr("ends within its header: the file is cut short, copy or export it again"),
         {},
         FilePlace{file}});
  const char* header = bytes.data();
  const auto major = valueAt<std::uint32_t>(header + 8);
  const auto pages = valueAt<std::uint64_t>(header + 40);
  E57Header result;
  result.minorVersion = valueAt<std::uint32_t>(header + 12);
  result.size = valueAt<std::uint64_t>(header + 16);
  result.xmlStart = valueAt<std::uint64_t>(header + 24);
  result.xmlSize = valueAt<std::uint64_t>(header + 32);
  if (major != 1)
    throw ShownError({Shown::tr("is E57 %1, and version 1 can be read: export it as that"),
                      {std::to_string(major) + '.' + std::to_string(result.minorVersion)},
                      FilePlace{.file = file, .byte = 8}});
  if (pages != pageSize)
    throw ShownError(
        {Shown::tr(
             "has pages of %1 bytes, not of %2: the header is damaged, copy or export it again"),
         {std::to_string(pages), std::to_string(pageSize)},
         FilePlace{.file = file, .byte = 40}});
  if (result.size > fileSize)
    throw ShownError({Shown::tr("its header promises %1 bytes, but it has %2: the file is cut "
                                "short, copy or export it again"),
                      {std::to_string(result.size), std::to_string(fileSize)},
                      FilePlace{file}});
  if (result.size == 0 || result.size % pageSize != 0)
    throw ShownError({Shown::tr("says it has %1 bytes, which are no whole pages: the header is "
                                "damaged, copy or export it again"),
                      {std::to_string(result.size)},
                      FilePlace{.file = file, .byte = 16}});
  return result;
}

std::string e57XmlOf(ByteSource& source, const std::string& file) {
  const E57Header header = readE57Header(source.read(0, e57HeaderSize), source.size(), file);
  const auto fail = [&] {
    throw ShownError(
        {espalier::Shown::tr("says that the XML of %1 bytes starts at byte %2, where none can "
                             "be: the file is damaged, copy or export it again"),
         {std::to_string(header.xmlSize), std::to_string(header.xmlStart)},
         FilePlace{file}});
  };
  if (header.xmlStart >= header.size || header.xmlStart % pageSize >= pageContent ||
      header.xmlSize > header.size)
    fail();
  const std::uint64_t inPage = header.xmlStart % pageSize;
  const std::uint64_t first = header.xmlStart / pageSize;
  const std::uint64_t count = (inPage + header.xmlSize + pageContent - 1) / pageContent;
  if (first + count > header.size / pageSize) fail();
  std::string content = source.read(first * pageSize, count * pageSize);
  takeChecksums(content, static_cast<std::size_t>(first), header.size / pageSize, file, {});
  return content.substr(static_cast<std::size_t>(inPage), static_cast<std::size_t>(header.xmlSize));
}

E57Pages::E57Pages(ByteSource& source, std::string file) : source_(source), file_(std::move(file)) {
  const E57Header header = readE57Header(source_.read(0, e57HeaderSize), source_.size(), file_);
  pages_ = header.size / pageSize;
  size_ = pages_ * pageContent;
}

std::uint64_t E57Pages::placeOf(std::uint64_t inFile, const char* ifNone) const {
  const std::uint64_t page = inFile / pageSize;
  const std::uint64_t inPage = inFile % pageSize;
  if (page >= pages_ || inPage >= pageContent)
    throw ShownError({ifNone, {std::to_string(inFile)}, FilePlace{file_}});
  return page * pageContent + inPage;
}

void E57Pages::require(std::uint64_t place, std::uint64_t size, const char* ifLess) const {
  const std::uint64_t left = size_ - std::min(place, size_);
  if (size > left) fail(place, {ifLess, {std::to_string(size), std::to_string(left)}});
}

std::string_view E57Pages::bytesAt(std::uint64_t place, std::size_t size, const char* ifLess) {
  constexpr std::uint64_t windowPages = 1024;
  require(place, size, ifLess);
  if (place < windowStart_ || place + size > windowStart_ + window_.size()) {
    const std::uint64_t first = place / pageContent;
    const std::uint64_t needed = (place + size + pageContent - 1) / pageContent - first;
    const std::uint64_t count = std::min(std::max(needed, windowPages), pages_ - first);
    window_ = source_.read(first * pageSize, count * pageSize);
    windowStart_ = first * pageContent;
    if (window_.size() < count * pageSize) throw becameShorter(file_);
    takeChecksums(window_, static_cast<std::size_t>(first), pages_, file_, {});
  }
  return std::string_view(window_).substr(static_cast<std::size_t>(place - windowStart_), size);
}

void E57Pages::fail(std::uint64_t place, ShownMessage what) const {
  const std::uint64_t inFile = place / pageContent * pageSize + place % pageContent;
  what.where = FilePlace{.file = file_, .byte = inFile};
  throw ShownError(std::move(what));
}

} // namespace espalier
