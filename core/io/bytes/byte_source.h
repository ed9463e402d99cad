#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace espalier {

/// A file whose bytes are read where they are needed: for files too large for the memory, and for
/// those of which little is asked.
class ByteSource {
public:
  /// @param in  of a file or a text, which can go back; must outlive the source
  explicit ByteSource(std::istream& in);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The bytes from `start` on: `count` of them, or as many as there are.
  [[nodiscard]] std::string read(std::uint64_t start, std::uint64_t count);

private:
  std::istream& in_;
  std::uint64_t size_ = 0;
};

} // namespace espalier
