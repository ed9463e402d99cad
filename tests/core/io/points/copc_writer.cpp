#include "tests/core/io/points/copc_writer.h"

#include "core/io/bytes/scalar.h"
#include "core/io/points/laz_layout.h"

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace espalier::test {
namespace {

constexpr std::size_t infoStart = 54; // after the header of its record
constexpr std::size_t infoSize = 160;

std::string copcRecord(const CopcOctree& octree, std::uint64_t pageStart, std::uint64_t pageSize) {
  std::string record(infoStart + infoSize, '\0');
  record.replace(2, 4, "copc");
  setValueAt(record.data() + 18, std::uint16_t{1});
  setValueAt(record.data() + 20, static_cast<std::uint16_t>(infoSize));
  char* info = record.data() + infoStart;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    setValueAt(info + 8 * axis, octree.center[axis]);
  setValueAt(info + 24, octree.halfSide);
  setValueAt(info + 40, pageStart);
  setValueAt(info + 48, pageSize);
  return record;
}

void appendEntry(std::string& page, const std::array<int, 4>& cell, std::uint64_t place,
                 std::int32_t size, std::int32_t points) {
  for (const int number : cell)
    appendValue(page, std::int32_t{number});
  appendValue(page, place);
  appendValue(page, size);
  appendValue(page, points);
}

/// The points of a LAZ file moved back, to make room for a record.
std::string withRoomForRecord(std::string laz, std::size_t room) {
  const auto headerSize = valueAt<std::uint16_t>(laz.data() + 94);
  const auto pointStart = valueAt<std::uint32_t>(laz.data() + 96);
  const auto table = valueAt<std::int64_t>(laz.data() + pointStart);
  setValueAt(laz.data() + pointStart, static_cast<std::int64_t>(table + std::int64_t(room)));
  setValueAt(laz.data() + 96, static_cast<std::uint32_t>(pointStart + room));
  setValueAt(laz.data() + 100, std::uint32_t{2});
  laz.insert(headerSize, room, '\0');
  return laz;
}

} // namespace

std::string copcFile(std::string laz, const CopcOctree& octree) {
  const auto headerSize = valueAt<std::uint16_t>(laz.data() + 94);
  constexpr std::size_t room = infoStart + infoSize;
  std::string file = withRoomForRecord(std::move(laz), room);
  file.replace(headerSize, room, copcRecord(octree, 0, 0)); // a record that can be passed over
  std::istringstream in(file);
  ByteSource source(in);
  const LasHeader header = readLasHeader(file, "sample");
  const std::vector<LazChunk> chunks = readLazLayout(source, header, "sample").chunks;
  // The page of a level ends with the entry that leads to that of the next.
  int deepest = 0;
  for (const auto& cell : octree.cells)
    deepest = std::max(deepest, cell[0]);
  std::string next;
  std::uint64_t nextStart = 0;
  for (int level = deepest; level >= 0; --level) {
    std::string page;
    for (std::size_t i = 0; i < chunks.size(); ++i)
      if (octree.cells[i][0] == level)
        appendEntry(page, octree.cells[i], chunks[i].start,
                    static_cast<std::int32_t>(chunks[i].size),
                    static_cast<std::int32_t>(chunks[i].count));
    if (!next.empty())
      appendEntry(page, {level + 1, 0, 0, 0}, nextStart, static_cast<std::int32_t>(next.size()),
                  -1);
    nextStart = file.size();
    file += page;
    next = page;
  }
  file.replace(headerSize, room, copcRecord(octree, nextStart, next.size()));
  return file;
}

} // namespace espalier::test
