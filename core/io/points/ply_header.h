#pragma once

#include "core/io/bytes/scalar.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::optional<ScalarType> countType; // of a list; none for a single value
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool hasLists() const;
  [[nodiscard]] std::uint64_t leastSize() const; // bytes in a binary file if all lists are empty
};

struct PlyHeader {
  bool isAscii = false;
  std::endian order = std::endian::little; // of a binary file
  std::vector<PlyElement> elements;
  std::vector<std::string_view> comments; // what follows the word, of the bytes read
  std::size_t dataStart = 0;              // in bytes
  std::size_t lines = 0;                  // of the header
};

/// The header at the beginning of a PLY file.
/// @throws Error naming the line that is wrong
[[nodiscard]] PlyHeader readPlyHeader(std::string_view bytes, const std::string& file);

} // namespace espalier
