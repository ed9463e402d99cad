#pragma once

#include "core/io/bytes/scalar.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::uint32_t count = 1; // values per point

  [[nodiscard]] std::uint64_t size() const { return count * sizeOf(type); } // bytes per point
};

enum class PcdData : std::uint8_t { ascii, binary, compressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdData data = PcdData::ascii;
  std::size_t dataStart = 0; // in bytes
  std::size_t lines = 0;     // of the header

  [[nodiscard]] std::uint64_t pointSize() const; // bytes of a point in a binary file
};

/// The header at the beginning of a PCD file.
/// @throws Error naming the line that is wrong
[[nodiscard]] PcdHeader readPcdHeader(std::string_view bytes, const std::string& file);

} // namespace espalier
