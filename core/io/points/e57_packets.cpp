#include "core/io/points/e57_packets.h"

#include "core/base/counted.h"
#include "core/base/paced_check.h"
#include "core/io/bytes/scalar.h"

#include <algorithm>
#include <string>

namespace espalier {
namespace {

constexpr std::size_t sectionHeaderSize = 32;
constexpr std::size_t packetHeaderSize = 4; // type, flags, length - 1
constexpr std::size_t bufferTableStart = 6; // of a packet of data: after the number of its buffers

enum class PacketType : std::uint8_t { index = 0, data = 1, empty = 2 };

bool areComplete(const E57Scan& scan, const std::vector<E57Stream>& streams) {
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (scan.fields[i].role != E57Role::none && !streams[i].has(scan.records)) return false;
  return true;
}

} // namespace

std::vector<E57Stream> E57Packets::streamsOf(const E57Scan& scan, const Progress& progress) {
  const Section section = sectionOf(scan);
  std::vector<E57Stream> streams(scan.fields.begin(), scan.fields.end());
  PacedCheck check(progress);
  std::size_t place = section.packets;
  bool isDone = areComplete(scan, streams); // asked again after data alone: fields may be many
  while (section.end - place >= packetHeaderSize && !isDone) {
    const std::string_view rest = pages_.bytesAt(place, section.end - place, "a section");
    const std::size_t size = std::size_t{valueAt<std::uint16_t>(rest.data() + 2)} + 1;
    const auto type = PacketType{valueAt<std::uint8_t>(rest.data())};
    if (type > PacketType::empty || size < packetHeaderSize || size > rest.size())
      pages_.fail(place, "expected a packet of type 0 to 2 within " + counted(rest.size(), "byte") +
                             ", found type " + std::to_string(static_cast<int>(type)) + " of " +
                             counted(size, "byte") +
                             ": the file is damaged, copy or export it again");
    if (type == PacketType::data) {
      addPacket(rest.substr(0, size), place, scan, streams);
      isDone = areComplete(scan, streams);
    }
    place += size;
    check.after(type == PacketType::data ? streams.size() : 1);
  }
  requireAll(scan, streams, place);
  return streams;
}

E57Packets::Section E57Packets::sectionOf(const E57Scan& scan) {
  const std::size_t start = pages_.placeOf(scan.start, "a section of points");
  const char* header = pages_.bytesAt(start, sectionHeaderSize, "the header of points").data();
  const unsigned kind = valueAt<std::uint8_t>(header);
  if (kind != 1)
    pages_.fail(start, "expected a section of points, which begins with 1, found " +
                           std::to_string(kind) + ": the file is damaged, copy or export it again");
  const auto size = valueAt<std::uint64_t>(header + 8);
  (void)pages_.bytesAt(start, size, "a section of points");
  const std::size_t packets =
      pages_.placeOf(valueAt<std::uint64_t>(header + 16), "the first packet of points");
  const Section section{packets, start + static_cast<std::size_t>(size)};
  if (packets < start + sectionHeaderSize || packets > section.end)
    pages_.fail(start, "the first packet of points is not within their section: the file is "
                       "damaged, copy or export it again");
  if (size > left_)
    pages_.fail(start, "two scans have the same section of points: the file is damaged, export it "
                       "again");
  left_ -= size;
  return section;
}

void E57Packets::addPacket(std::string_view packet, std::size_t place, const E57Scan& scan,
                           std::vector<E57Stream>& streams) const {
  const auto failure = [&](const std::string& what) {
    pages_.fail(place, what + ": the file is damaged, copy or export it again");
  };
  if (packet.size() < bufferTableStart) failure("a packet of data ends within its header");
  const std::size_t count = valueAt<std::uint16_t>(packet.data() + packetHeaderSize);
  if (count != streams.size())
    failure("a packet of data has " + counted(count, "stream") + ", but its points have " +
            counted(streams.size(), "field"));
  std::size_t at = bufferTableStart + 2 * count;
  if (at > packet.size()) failure("a packet of data ends within its header");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = valueAt<std::uint16_t>(packet.data() + bufferTableStart + 2 * i);
    if (size > packet.size() - at) failure("the streams of a packet of data are longer than it is");
    if (scan.fields[i].role != E57Role::none) streams[i].add(packet.substr(at, size));
    at += size;
  }
}

void E57Packets::requireAll(const E57Scan& scan, const std::vector<E57Stream>& streams,
                            std::size_t end) const {
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (scan.fields[i].role != E57Role::none && !streams[i].has(scan.records))
      pages_.fail(std::min(end, pages_.size() - 1),
                  "the packets end here, with " + std::to_string(streams[i].values()) + " of " +
                      counted(scan.records, "point") +
                      ": the file is damaged, copy or export it again");
}

} // namespace espalier
