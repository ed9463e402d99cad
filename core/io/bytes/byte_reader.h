#pragma once

#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace espalier {

/// Takes values off the bytes of a file one after another, and never reads past their end.
class ByteReader {
public:
  /// @param bytes  must outlive the reader
  /// @param file   its name, for messages
  ByteReader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - offset_; }
  [[nodiscard]] bool isAtEnd() const { return left() == 0; }

  /// @throws Error if so many bytes are not left
  std::string_view take(std::uint64_t size) {
    if (size > left()) failOfEnd(size);
    const std::string_view taken = bytes_.substr(offset_, static_cast<std::size_t>(size));
    offset_ += static_cast<std::size_t>(size);
    return taken;
  }

  /// @throws Error if the file ends before
  template <class T> T value(std::endian order = std::endian::little) {
    return valueAt<T>(take(sizeof(T)).data(), order);
  }

  /// The bytes up to `end`, which is taken too.
  /// @throws Error if there is no such byte
  std::string_view takeUntil(char end);

  /// @throws ShownError always: "oak.bgeom, byte 120: what"
  [[noreturn]] void fail(ShownMessage what) const { failAt(offset_, std::move(what)); }
  [[noreturn]] void failAt(std::size_t offset, ShownMessage what) const;

private:
  [[noreturn]] void failOfEnd(std::uint64_t size) const;

  std::string_view bytes_;
  std::string file_;
  std::size_t offset_ = 0;
};

} // namespace espalier
