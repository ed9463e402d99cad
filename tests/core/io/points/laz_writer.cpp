#include "tests/core/io/points/laz_writer.h"

#include "core/base/random.h"
#include "core/io/points/las_header.h"
#include "tests/core/io/points/laz_chunk_encoders.h"

#include <array>
#include <utility>

namespace espalier::test {
namespace {

std::vector<LazItem> itemsFor(const LasHeader& header, int version) {
  using enum LazItemType;
  const auto number = static_cast<std::uint16_t>(version);
  std::vector<LazItem> items;
  std::size_t size = 0;
  const auto add = [&](LazItemType type, std::size_t length) {
    items.push_back({type, static_cast<std::uint16_t>(length), number});
    size += length;
  };
  if (header.format < 6) {
    add(point10, 20);
    if (header.format == 1 || header.format == 3) add(gpsTime, 8);
    if (header.format >= 2) add(rgb12, 6);
  } else {
    add(point14, 30);
    if (header.format == 7) add(rgb14, 6);
    if (header.format == 8) add(rgbNir14, 8);
  }
  if (header.pointLength > size)
    add(header.format < 6 ? bytes : bytes14, header.pointLength - size);
  return items;
}

std::string lazRecord(const std::vector<LazItem>& items, std::uint16_t compressor,
                      std::uint32_t chunkSize) {
  std::string record;
  appendValue(record, compressor);
  appendValue(record, std::uint16_t{0}); // coder
  appendValue(record, std::uint32_t{3}); // version of the writer
  appendValue(record, std::uint32_t{0}); // options
  appendValue(record, chunkSize);
  appendValue(record, std::int64_t{-1});
  appendValue(record, std::int64_t{-1});
  appendValue(record, static_cast<std::uint16_t>(items.size()));
  for (const LazItem& item : items) {
    appendValue(record, static_cast<std::uint16_t>(item.type));
    appendValue(record, item.size);
    appendValue(record, item.version);
  }
  std::string header("\0\0laszip encoded\0\0", 18);
  appendValue(header, std::uint16_t{22204});
  appendValue(header, static_cast<std::uint16_t>(record.size()));
  header.resize(54);
  return header + record;
}

struct PackedChunk {
  std::string bytes;
  std::size_t points;
};

std::string chunkTable(const std::vector<PackedChunk>& chunks, bool hasCounts) {
  std::string table;
  appendValue(table, std::uint32_t{0}); // version
  appendValue(table, static_cast<std::uint32_t>(chunks.size()));
  if (chunks.empty()) return table;
  RangeEncoder out;
  IntegerEncoder numbers(32, 2);
  std::int32_t count = 0;
  std::int32_t size = 0;
  for (const PackedChunk& chunk : chunks) {
    if (hasCounts) numbers.next(out, count, static_cast<std::int32_t>(chunk.points), 0);
    numbers.next(out, size, static_cast<std::int32_t>(chunk.bytes.size()), 1);
    count = static_cast<std::int32_t>(chunk.points);
    size = static_cast<std::int32_t>(chunk.bytes.size());
  }
  return table + std::move(out).finish();
}

std::vector<std::string> pointsIn(const std::string& las, const LasHeader& header) {
  std::vector<std::string> points;
  for (std::uint64_t i = 0; i < header.count; ++i)
    points.push_back(las.substr(header.pointStart + i * header.pointLength, header.pointLength));
  return points;
}

} // namespace

std::string lazFile(const std::string& las, const LazForm& form) {
  const LasHeader header = readLasHeader(las, "sample");
  const bool isLayered = header.format >= 6;
  const int version = form.version > 0 ? form.version : isLayered ? 3 : 2;
  const std::vector<LazItem> items = itemsFor(header, version);
  const std::vector<std::string> points = pointsIn(las, header);
  std::vector<PackedChunk> chunks;
  std::size_t size = form.chunkSize > 0 ? form.chunkSize : points.size();
  for (std::size_t i = 0; i < points.size(); i += chunks.back().points) {
    if (form.hasChunksOfAnySize && i > 0) ++size;
    const std::vector<std::string> part(
        points.begin() + static_cast<std::ptrdiff_t>(i),
        points.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, points.size())));
    chunks.push_back(
        {isLayered ? layeredChunk(part, items) : pointwiseChunk(part, items), part.size()});
  }
  const bool hasTable = form.chunkSize > 0;
  std::string file = las.substr(0, header.size);
  file += lazRecord(items,
                    isLayered  ? 3
                    : hasTable ? 2
                               : 1,
                    form.hasChunksOfAnySize ? 0xffffffff : form.chunkSize);
  setValueAt(file.data() + 96, static_cast<std::uint32_t>(file.size()));
  setValueAt(file.data() + 100, std::uint32_t{1});
  file[104] = static_cast<char>(byteOf(file.data() + 104) | 0x80);
  const std::size_t start = file.size();
  if (hasTable) appendValue(file, std::int64_t{-1});
  for (const PackedChunk& chunk : chunks)
    file += chunk.bytes;
  if (!hasTable) return file;
  const auto tableStart = static_cast<std::int64_t>(file.size());
  if (!form.hasTableAtEnd) setValueAt(file.data() + start, tableStart);
  file += chunkTable(chunks, form.hasChunksOfAnySize);
  if (form.hasTableAtEnd) appendValue(file, tableStart);
  return file;
}

std::string withNoise(std::string las, std::uint64_t seed) {
  const LasHeader header = readLasHeader(las, "sample");
  Random random(seed);
  std::array<std::uint32_t, 3> position{1000, 2000, 3000}; // may wrap around
  for (std::uint64_t i = 0; i < header.count; ++i) {
    char* point = las.data() + header.pointStart + i * header.pointLength;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t reach = 1U << random.below(31); // steps of all sizes
      position[axis] += static_cast<std::uint32_t>(random.below(2 * reach)) - reach;
      setValueAt(point + 4 * axis, position[axis]);
    }
    for (std::size_t at = 12; at < header.pointLength; ++at)
      if (random.below(3) > 0) point[at] = static_cast<char>(random.below(256));
    if (header.format >= 6 && random.below(2) > 0) point[15] &= 0x4f; // mostly in channel 0
    if (const std::size_t start = header.colorStart(); start > 0 && random.below(4) == 0)
      std::copy_n("grgrgr", 6, point + start);
  }
  return las;
}

} // namespace espalier::test
