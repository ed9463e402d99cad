#pragma once

#include "core/io/bytes/byte_source.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace espalier {

/// The bytes of a source one after another, of which a few MB at a time are in memory.
class ByteStream {
public:
  /// @param source  must outlive the stream
  ByteStream(ByteSource& source, std::uint64_t start);

  [[nodiscard]] std::uint64_t left() const { return unread_ + (block_.size() - at_); }

  /// The next bytes, which are there until the next call; null if the file has become shorter than
  /// it was. pre: count <= left()
  [[nodiscard]] const char* take(std::size_t count) {
    if (count > block_.size() - at_ && !fill(count)) return nullptr;
    const char* bytes = block_.data() + at_;
    at_ += count;
    return bytes;
  }

  /// pre: count <= left()
  void skip(std::uint64_t count);

private:
  bool fill(std::size_t count);

  ByteSource& source_;
  std::uint64_t unread_; // bytes of the source behind the block
  std::string block_;
  std::size_t at_ = 0; // in the block
};

} // namespace espalier
