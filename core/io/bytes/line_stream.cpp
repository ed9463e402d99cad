#include "core/io/bytes/line_stream.h"

#include <algorithm>

namespace espalier {

LineStream::LineStream(ByteSource& source, std::uint64_t start)
    : source_(source), next_(start), size_(source.size() - std::min(start, source.size())) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (source_.read(start, mark.size()) != mark) return;
  next_ += mark.size();
  offset_ = mark.size();
}

/// Reads on; a line as long as the block doubles it. Whether there was more.
bool LineStream::fill() {
  constexpr std::size_t blockSize = std::size_t{1} << 20;
  block_.erase(0, at_);
  at_ = 0;
  const std::string more = source_.read(next_, std::max(blockSize, block_.size()));
  next_ += more.size();
  block_ += more;
  return !more.empty();
}

std::optional<std::string_view> LineStream::next() {
  std::size_t end = block_.find('\n', at_);
  while (end == std::string::npos) {
    const std::size_t searched = block_.size() - at_;
    if (!fill()) break;
    end = block_.find('\n', searched);
  }
  if (at_ == block_.size()) return std::nullopt;
  const std::size_t lineEnd = std::min(end, block_.size());
  std::string_view line = std::string_view(block_).substr(at_, lineEnd - at_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  const std::size_t after = std::min(lineEnd + 1, block_.size());
  offset_ += after - at_;
  at_ = after;
  ++number_;
  return line;
}

} // namespace espalier
