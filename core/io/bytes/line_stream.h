#pragma once

#include "core/io/bytes/byte_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// The lines of a text as LineReader gives them, of which a few MB at a time are in memory.
class LineStream {
public:
  /// @param source  must outlive the stream
  /// @param start   of the first line
  explicit LineStream(ByteSource& source, std::uint64_t start = 0);

  /// The next line without its end, which is there until the next call; none after the last.
  [[nodiscard]] std::optional<std::string_view> next();

  [[nodiscard]] std::size_t number() const { return number_; }   // of the line last read, from 1
  [[nodiscard]] std::uint64_t offset() const { return offset_; } // bytes read since the start
  [[nodiscard]] std::uint64_t size() const { return size_; }     // bytes from the start on

private:
  bool fill();

  ByteSource& source_;
  std::uint64_t next_; // place in the source of what follows the block
  std::string block_;
  std::size_t at_ = 0; // in the block
  std::uint64_t size_;
  std::uint64_t offset_ = 0;
  std::size_t number_ = 0;
};

} // namespace espalier
