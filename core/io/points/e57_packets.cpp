#include "core/io/points/e57_packets.h"

#include "core/base/paced_check.h"
#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"

#include <algorithm>
#include <limits>
#include <string>

namespace espalier {
namespace {

constexpr std::size_t sectionHeaderSize = 32;
constexpr std::size_t packetHeaderSize = 4; // type, flags, length - 1
constexpr std::size_t bufferTableStart = 6; // of a packet of data: after the number of its buffers
constexpr const char* packetTooLong = espalier::Shown::tr(
    "a packet of %1 bytes starts here, but only %2 follow: the file is damaged, copy or "
    "export it again");

enum class PacketType : std::uint8_t { index = 0, data = 1, empty = 2 };

} // namespace

std::vector<E57Stream> E57Packets::begin(const E57Scan& scan) {
  scan_ = &scan;
  enterSection();
  return {scan.fields.begin(), scan.fields.end()};
}

std::uint64_t E57Packets::readOn(std::vector<E57Stream>& streams, const Progress& progress) {
  PacedCheck check(progress);
  std::uint64_t ready = readyIn(streams);
  while (ready == 0) { // asked again after data alone: fields may be many
    if (end_ - place_ < packetHeaderSize) failAtEnd(streams);
    const char* header = pages_.bytesAt(place_, packetHeaderSize, packetTooLong).data();
    const std::size_t size = std::size_t{valueAt<std::uint16_t>(header + 2)} + 1;
    const auto type = PacketType{valueAt<std::uint8_t>(header)};
    const std::uint64_t rest = end_ - place_;
    if (type > PacketType::empty || size < packetHeaderSize || size > rest)
      pages_.fail(
          place_,
          {Shown::tr("expected a packet of type 0 to 2 within %1 bytes, found type %2 of %3 bytes: "
                     "the file is damaged, copy or export it again"),
           {std::to_string(rest), std::to_string(static_cast<int>(type)), std::to_string(size)}});
    if (type == PacketType::data) {
      addPacket(pages_.bytesAt(place_, size, packetTooLong), streams);
      ready = readyIn(streams);
    }
    place_ += size;
    check.after(type == PacketType::data ? streams.size() : 1);
  }
  return ready;
}

std::uint64_t E57Packets::readyIn(const std::vector<E57Stream>& streams) const {
  std::uint64_t ready = std::numeric_limits<std::uint64_t>::max();
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (scan_->fields[i].role != E57Role::none) ready = std::min(ready, streams[i].ready());
  return ready;
}

void E57Packets::enterSection() {
  const std::uint64_t start = pages_.placeOf(
      scan_->start, Shown::tr("says that a section of points starts at byte %1, where none can be: "
                              "the file is damaged, copy or export it again"));
  const std::string header(
      pages_.bytesAt(start, sectionHeaderSize,
                     Shown::tr("the header of points of %1 bytes starts here, but only %2 follow: "
                               "the file is damaged, copy or export it again")));
  const unsigned kind = valueAt<std::uint8_t>(header.data());
  if (kind != 1)
    pages_.fail(start, {Shown::tr("expected a section of points, which begins with 1, found %1: "
                                  "the file is damaged, copy or export it again"),
                        {std::to_string(kind)}});
  const auto size = valueAt<std::uint64_t>(header.data() + 8);
  pages_.require(start, size,
                 Shown::tr("a section of points of %1 bytes starts here, but only %2 follow: the "
                           "file is damaged, copy or export it again"));
  place_ = pages_.placeOf(valueAt<std::uint64_t>(header.data() + 16),
                          Shown::tr("says that the first packet of points starts at byte %1, where "
                                    "none can be: the file is damaged, copy or export it again"));
  end_ = start + size;
  if (place_ < start + sectionHeaderSize || place_ > end_)
    pages_.fail(start, {Shown::tr("the first packet of points is not within their section: the "
                                  "file is damaged, copy or export it again")});
  if (size > left_)
    pages_.fail(
        start,
        {Shown::tr(
            "two scans have the same section of points: the file is damaged, export it again")});
  left_ -= size;
}

void E57Packets::addPacket(std::string_view packet, std::vector<E57Stream>& streams) const {
  const auto failOfHeader = [&] {
    pages_.fail(place_, {Shown::tr("a packet of data ends within its header: the file is damaged, "
                                   "copy or export it again")});
  };
  if (packet.size() < bufferTableStart) failOfHeader();
  const std::size_t count = valueAt<std::uint16_t>(packet.data() + packetHeaderSize);
  if (count != streams.size())
    pages_.fail(place_, {Shown::tr("a packet of data has %1 streams, but its points have %2 "
                                   "fields: the file is damaged, copy or export it again"),
                         {std::to_string(count), std::to_string(streams.size())}});
  std::size_t at = bufferTableStart + 2 * count;
  if (at > packet.size()) failOfHeader();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = valueAt<std::uint16_t>(packet.data() + bufferTableStart + 2 * i);
    if (size > packet.size() - at)
      pages_.fail(place_, {Shown::tr("the streams of a packet of data are longer than it is: the "
                                     "file is damaged, copy or export it again")});
    if (scan_->fields[i].role != E57Role::none) streams[i].add(packet.substr(at, size));
    at += size;
  }
}

void E57Packets::failAtEnd(const std::vector<E57Stream>& streams) const {
  std::uint64_t values = 0;
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (scan_->fields[i].role != E57Role::none && streams[i].ready() == 0)
      values = streams[i].values();
  pages_.fail(std::min(place_, pages_.size() - 1),
              {Shown::tr("the packets end here, with %1 of %2 points: the file is damaged, copy or "
                         "export it again"),
               {std::to_string(values), std::to_string(scan_->records)}});
}

} // namespace espalier
