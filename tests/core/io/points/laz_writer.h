#pragma once

#include <cstdint>
#include <string>

namespace espalier::test {

/// How a LAS file is compressed.
struct LazForm {
  int version = 0;                 // of its items; 0: 2 of formats 0 to 5, 3 of formats 6 to 10
  std::uint32_t chunkSize = 50;    // points; 0: all in one, without a table of chunks
  bool hasChunksOfAnySize = false; // each one point larger than the one before
  bool hasTableAtEnd = false;      // as writers do that cannot go back
};

/// `las` compressed as LASzip does. Of formats 6 to 10, only what readers of points need is real:
/// the other layers hold a few bytes of nothing.
/// pre: a LAS file of format 0 to 3 or 6 to 8; version 1 of format 0 only
[[nodiscard]] std::string lazFile(const std::string& las, const LazForm& form = {});

/// `las` with numbers in all fields of its points that jump as those of a real scan do not: seeded
/// walks of positions, and noise in the rest.
[[nodiscard]] std::string withNoise(std::string las, std::uint64_t seed);

} // namespace espalier::test
