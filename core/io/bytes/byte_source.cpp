#include "core/io/bytes/byte_source.h"

#include <algorithm>
#include <istream>

namespace espalier {

ByteSource::ByteSource(std::istream& in) : in_(in) {
  in_.clear();
  in_.seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(in_.tellg(), 0));
  in_.seekg(0);
}

std::string ByteSource::read(std::uint64_t start, std::uint64_t count) {
  if (start >= size_) return {};
  std::string bytes(static_cast<std::size_t>(std::min(count, size_ - start)), '\0');
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(start));
  in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in_.gcount(), 0)));
  return bytes;
}

} // namespace espalier
