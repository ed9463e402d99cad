#pragma once

#include "core/io/bytes/byte_source.h"

#include <cstdint>
#include <functional>
#include <string_view>

namespace espalier {

/// Calls `take` with some records of one size from places spread evenly through a file: all of up
/// to 2^14, else about as many, in short runs.
/// @param start  of the first record; those that the file lacks are passed over
void sampleRecords(ByteSource& source, std::uint64_t start, std::uint64_t recordSize,
                   std::uint64_t count, const std::function<void(const char*)>& take);

/// What was seen of the lines of a text.
struct LineSample {
  std::uint64_t lines = 0; // that `take` counted
  std::uint64_t bytes = 0; // of all that it was called with
  bool isAll = false;      // no line was passed over

  /// How many lines there are in so many bytes.
  [[nodiscard]] std::uint64_t linesIn(std::uint64_t allBytes) const;
};

/// Calls `take` with whole lines from places spread evenly through a text from `start` on; it says
/// whether the line counts. Of up to 4 MiB it is called with all lines, else with those of 2 MiB.
[[nodiscard]] LineSample sampleLines(ByteSource& source, std::uint64_t start,
                                     const std::function<bool(std::string_view)>& take);

} // namespace espalier
