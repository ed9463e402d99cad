#include "core/io/bytes/byte_reader.h"

#include "core/base/error.h"

namespace espalier {

std::string_view ByteReader::takeUntil(char end) {
  const std::size_t at = bytes_.find(end, offset_);
  if (at == std::string_view::npos)
    fail("ends within a text: the file is cut short or damaged, copy or export it again");
  const std::string_view taken = take(at - offset_);
  ++offset_;
  return taken;
}

void ByteReader::failAt(std::size_t offset, std::string_view what) const {
  throw Error(file_ + ", byte " + std::to_string(offset) + ": " + std::string(what));
}

void ByteReader::failOfEnd(std::uint64_t size) const {
  fail("ends within a value of " + std::to_string(size) +
       " bytes: the file is cut short or damaged, copy or export it again");
}

} // namespace espalier
