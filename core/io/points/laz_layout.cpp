#include "core/io/points/laz_layout.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"
#include "core/io/points/integer_decoder.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint32_t chunksOfAnySize = 0xffffffff;

/// The record of LASzip among the variable length records.
struct LazRecord {
  std::uint16_t compressor = 0;
  std::uint16_t coder = 0;
  std::uint32_t chunkSize = 0; // points
  std::vector<LazItem> items;
};

enum Compressor : std::uint16_t { pointwise = 1, pointwiseChunked = 2, layeredChunked = 3 };

ShownError damagedLaz(const std::string& file, const char* sentence,
                      std::vector<std::string> values = {}) {
  return ShownError({sentence, std::move(values), FilePlace{file}});
}

LazRecord lazRecordOf(std::string_view bytes, const std::string& file) {
  constexpr std::size_t itemsStart = 34;
  constexpr std::size_t itemSize = 6;
  LazRecord record;
  const std::size_t count =
      bytes.size() < itemsStart ? 0 : valueAt<std::uint16_t>(bytes.data() + itemsStart - 2);
  if (count == 0 || bytes.size() < itemsStart + count * itemSize)
    throw damagedLaz(file, Shown::tr("ends within its record of LASzip: the file is cut short or "
                                     "damaged, copy or export it again"));
  record.compressor = valueAt<std::uint16_t>(bytes.data());
  record.coder = valueAt<std::uint16_t>(bytes.data() + 2);
  record.chunkSize = valueAt<std::uint32_t>(bytes.data() + 12);
  for (std::size_t i = 0; i < count; ++i) {
    const char* item = bytes.data() + itemsStart + i * itemSize;
    record.items.push_back({static_cast<LazItemType>(valueAt<std::uint16_t>(item)),
                            valueAt<std::uint16_t>(item + 2), valueAt<std::uint16_t>(item + 4)});
  }
  return record;
}

/// The items of a point format without extra bytes.
std::vector<LazItemType> itemsOfFormat(std::size_t format) {
  using enum LazItemType;
  static const std::array<std::vector<LazItemType>, 11> items = {
      {{point10},
       {point10, gpsTime},
       {point10, rgb12},
       {point10, gpsTime, rgb12},
       {point10, gpsTime, wavePacket13},
       {point10, gpsTime, rgb12, wavePacket13},
       {point14},
       {point14, rgb14},
       {point14, rgbNir14},
       {point14, wavePacket14},
       {point14, rgbNir14, wavePacket14}}};
  return items[format];
}

std::size_t sizeOf(LazItemType type, std::size_t extraBytes) {
  using enum LazItemType;
  switch (type) {
  case point10:
    return 20;
  case gpsTime:
  case rgbNir14:
    return 8;
  case rgb12:
  case rgb14:
    return 6;
  case wavePacket13:
  case wavePacket14:
    return 29;
  case point14:
    return 30;
  default:
    return extraBytes;
  }
}

void checkItems(const std::vector<LazItem>& items, const LasHeader& header,
                const std::string& file) {
  std::vector<LazItemType> expected = itemsOfFormat(header.format);
  std::size_t extraBytes = header.pointLength;
  for (const LazItemType type : expected)
    extraBytes -= sizeOf(type, 0);
  if (extraBytes > 0)
    expected.push_back(header.format < 6 ? LazItemType::bytes : LazItemType::bytes14);
  const bool isAsExpected =
      std::ranges::equal(items, expected, [&](const LazItem& item, LazItemType type) {
        return item.type == type && item.size == sizeOf(type, extraBytes);
      });
  if (!isAsExpected)
    throw damagedLaz(
        file,
        Shown::tr("says of what its points consist, but not as points of format %1 with %2 bytes "
                  "do: the file is cut short or damaged, copy or export it again"),
        {std::to_string(header.format), std::to_string(header.pointLength)});
}

bool isReadable(const LazItem& item) {
  using enum LazItemType;
  switch (item.type) {
  case point10:
  case bytes:
    return item.version == 1 || item.version == 2;
  case gpsTime:
  case rgb12:
    return item.version == 2;
  case wavePacket13:
    return false;
  default:
    return item.version == 3 || item.version == 4;
  }
}

/// Refuses other methods, and says what can always be done: LASzip reads whatever it once wrote.
void checkCompression(const LazRecord& record, const std::string& file) {
  if (record.compressor < pointwise || record.compressor > layeredChunked)
    throw ShownError({Shown::tr("is compressed by a method of number %1, and 1 to 3 can be read: "
                                "unpack it to LAS, as by 'laszip -i %2 -o unpacked.las'"),
                      {std::to_string(record.compressor), file},
                      FilePlace{file}});
  if (record.coder != 0)
    throw ShownError({Shown::tr("is compressed by a coder of number %1, and 0 can be read: unpack "
                                "it to LAS, as by 'laszip -i %2 -o unpacked.las'"),
                      {std::to_string(record.coder), file},
                      FilePlace{file}});
}

void checkVersions(const std::vector<LazItem>& items, const std::string& file) {
  for (const LazItem& item : items)
    if (!isReadable(item))
      throw ShownError(
          {Shown::tr("has parts of points (item %1) that are compressed in version %2, which "
                     "cannot be read: unpack it to LAS, as by 'laszip -i %3 -o unpacked.las'"),
           {std::to_string(static_cast<int>(item.type)), std::to_string(item.version), file},
           FilePlace{file}});
}

void checkRecord(const LazRecord& record, const LasHeader& header, const std::string& file) {
  checkCompression(record, file);
  checkItems(record.items, header, file);
  checkVersions(record.items, file);
  if ((record.compressor == layeredChunked) != (header.format >= 6))
    throw damagedLaz(
        file,
        Shown::tr("says its points of format %1 are compressed by method %2, which is for other "
                  "formats: the file is cut short or damaged, copy or export it again"),
        {std::to_string(header.format), std::to_string(record.compressor)});
}

constexpr std::size_t tableHeader = 8; // version, and how many chunks are listed

/// Where the table of chunks lies: before the first chunk, else, where its writer could not go back
/// in the file, at the end.
std::uint64_t chunkTableStart(ByteSource& source, const LasHeader& header,
                              const std::string& file) {
  constexpr std::size_t offsetSize = 8;
  const std::uint64_t least = header.pointStart + offsetSize;
  const auto placeAt = [&](std::uint64_t start) {
    const std::string bytes = source.read(start, offsetSize);
    if (bytes.size() < offsetSize)
      throw damagedLaz(file,
                       espalier::Shown::tr("ends before its first point: the file is cut short or "
                                           "damaged, copy or export it again"));
    return valueAt<std::uint64_t>(bytes.data());
  };
  auto start = placeAt(header.pointStart);
  if (start == ~std::uint64_t{0}) start = placeAt(source.size() - offsetSize);
  if (start < least || start > source.size() || source.size() - start < tableHeader)
    throw damagedLaz(
        file, espalier::Shown::tr("has no table of its chunks of points where it should be: the "
                                  "file is cut short or damaged, copy or export it again"));
  return start;
}

/// Reads the counts and sizes of chunks one after the other.
class ChunkTableReader {
public:
  explicit ChunkTableReader(std::string_view bytes) : in_(bytes) {}

  [[nodiscard]] LazChunk next(std::uint32_t pointsPerChunk) {
    LazChunk chunk;
    if (pointsPerChunk == chunksOfAnySize) count_ = numbers_.next(in_, count_, 0);
    size_ = numbers_.next(in_, size_, 1);
    chunk.count =
        pointsPerChunk == chunksOfAnySize ? static_cast<std::uint32_t>(count_) : pointsPerChunk;
    chunk.size = static_cast<std::uint32_t>(size_);
    return chunk;
  }

private:
  RangeDecoder in_;
  IntegerDecoder numbers_{32, 2};
  std::int32_t count_ = 0; // bits of an unsigned number, as size_
  std::int32_t size_ = 0;
};

/// The chunks that the table at `tableStart` lists, as many as the points need.
std::vector<LazChunk> tabledChunks(ByteSource& source, std::uint64_t tableStart,
                                   const LasHeader& header, std::uint32_t pointsPerChunk) {
  constexpr std::uint64_t mostPerChunk = 32; // bytes of two packed numbers, at their longest
  constexpr std::uint64_t decoderBytes = 64; // that it reads ahead
  std::vector<LazChunk> chunks;
  std::uint64_t start = header.pointStart + 8;
  std::uint64_t left = header.count;
  const std::string head = source.read(tableStart, tableHeader);
  if (head.size() < tableHeader) throw DamagedStream{};
  const auto listed = valueAt<std::uint32_t>(head.data() + 4);
  const std::string bytes =
      source.read(tableStart + tableHeader, decoderBytes + mostPerChunk * listed);
  ChunkTableReader table(bytes);
  for (std::uint32_t i = 0; i < listed && left > 0; ++i) {
    LazChunk chunk = table.next(pointsPerChunk);
    if (chunk.size > tableStart - start) throw DamagedStream{};
    chunk.start = start;
    start += chunk.size;
    chunk.count = std::min(chunk.count, left);
    left -= chunk.count;
    if (chunk.count == 0) continue; // a cell of an octree without points
    if (chunk.size < header.pointLength) throw DamagedStream{};
    chunks.push_back(chunk);
  }
  if (left > 0) throw DamagedStream{};
  return chunks;
}

std::vector<LazChunk> chunksOf(ByteSource& source, const LazRecord& record, const LasHeader& header,
                               const std::string& file) {
  if (header.count == 0) return {};
  if (record.compressor == pointwise) // all in one
    return {{header.pointStart, source.size() - header.pointStart, header.count}};
  const std::uint64_t tableStart = chunkTableStart(source, header, file);
  try {
    return tabledChunks(source, tableStart, header, record.chunkSize);
  } catch (const DamagedStream&) {
    throw damagedLaz(file,
                     Shown::tr("has a table of chunks that does not fit its %1 points: the file is "
                               "cut short or damaged, copy or export it again"),
                     {std::to_string(header.count)});
  }
}

} // namespace

LazLayout readLazLayout(ByteSource& source, const LasHeader& header, const std::string& file) {
  constexpr std::uint16_t lazRecordId = 22204;
  const std::string head = source.read(0, header.pointStart);
  const auto bytes = lasRecord(head, header, "laszip encoded", lazRecordId);
  if (bytes.data() == nullptr)
    throw damagedLaz(file, Shown::tr("has no record of LASzip on how its points are compressed: "
                                     "the file is cut short or damaged, copy or export it again"));
  const LazRecord record = lazRecordOf(bytes, file);
  checkRecord(record, header, file);
  LazLayout layout;
  layout.isLayered = record.compressor == layeredChunked;
  layout.items = record.items;
  layout.chunks = chunksOf(source, record, header, file);
  return layout;
}

} // namespace espalier
