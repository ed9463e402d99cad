#pragma once

#include "core/io/bytes/byte_source.h"
#include "core/io/points/las_header.h"

#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// A part of each point, by the numbers that LAZ files give them.
enum class LazItemType : std::uint16_t {
  bytes = 0,
  point10 = 6, // x, y, z and more, of formats 0 to 5
  gpsTime = 7,
  rgb12 = 8,
  wavePacket13 = 9,
  point14 = 10, // of formats 6 to 10
  rgb14 = 11,
  rgbNir14 = 12,
  wavePacket14 = 13,
  bytes14 = 14
};

struct LazItem {
  LazItemType type = LazItemType::bytes;
  std::uint16_t size = 0;    // bytes in a point
  std::uint16_t version = 0; // of how it is compressed
};

/// Points that are compressed together, apart from all others.
struct LazChunk {
  std::uint64_t start = 0; // within the file
  std::uint64_t size = 0;  // in bytes
  std::uint64_t count = 0; // points, > 0
};

/// How the points of a LAZ file are compressed.
struct LazLayout {
  bool isLayered = false; // each field of a chunk on its own, else all of a point together
  std::vector<LazItem> items;
  std::vector<LazChunk> chunks; // of header.count points; each lies within the file
};

/// @param source  the file, of which its head and its table of chunks are read
/// @param header  its header
/// @param file    its name, for messages
/// @throws Error if it is damaged, or compressed in a form that cannot be read
[[nodiscard]] LazLayout readLazLayout(ByteSource& source, const LasHeader& header,
                                      const std::string& file);

} // namespace espalier
