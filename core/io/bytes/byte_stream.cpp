#include "core/io/bytes/byte_stream.h"

#include <algorithm>

namespace espalier {

ByteStream::ByteStream(ByteSource& source, std::uint64_t start)
    : source_(source), unread_(source.size() - std::min(start, source.size())) {}

bool ByteStream::fill(std::size_t count) {
  constexpr std::size_t blockSize = std::size_t{1} << 22;
  block_.erase(0, at_);
  at_ = 0;
  const std::string more = source_.read(source_.size() - unread_, std::max(blockSize, count));
  unread_ -= more.size();
  block_ += more;
  return block_.size() >= count;
}

void ByteStream::skip(std::uint64_t count) {
  const std::uint64_t here = std::min<std::uint64_t>(count, block_.size() - at_);
  at_ += static_cast<std::size_t>(here);
  unread_ -= count - here;
}

} // namespace espalier
