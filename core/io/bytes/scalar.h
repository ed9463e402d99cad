#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace espalier {

/// How a number lies in a binary file.
enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

[[nodiscard]] constexpr std::size_t sizeOf(ScalarType type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

[[nodiscard]] constexpr bool isFloat(ScalarType type) {
  return type == ScalarType::float32 || type == ScalarType::float64;
}

/// "int8", ..., "float", "double".
[[nodiscard]] constexpr const char* nameOf(ScalarType type) {
  constexpr std::array<const char*, 10> names = {"int8",   "uint8", "int16",  "uint16", "int32",
                                                 "uint32", "int64", "uint64", "float",  "double"};
  return names[static_cast<std::size_t>(type)];
}

/// The value at `bytes`, aligned or not. pre: sizeof(T) bytes are there
template <class T>
[[nodiscard]] T valueAt(const char* bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
      std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(raw);
}

/// The value at `bytes` as a double. pre: sizeOf(type) bytes are there
[[nodiscard]] inline double scalarAt(const char* bytes, ScalarType type,
                                     std::endian order = std::endian::little) {
  switch (type) {
  case ScalarType::int8:
    return valueAt<std::int8_t>(bytes, order);
  case ScalarType::uint8:
    return valueAt<std::uint8_t>(bytes, order);
  case ScalarType::int16:
    return valueAt<std::int16_t>(bytes, order);
  case ScalarType::uint16:
    return valueAt<std::uint16_t>(bytes, order);
  case ScalarType::int32:
    return valueAt<std::int32_t>(bytes, order);
  case ScalarType::uint32:
    return valueAt<std::uint32_t>(bytes, order);
  case ScalarType::int64:
    return static_cast<double>(valueAt<std::int64_t>(bytes, order));
  case ScalarType::uint64:
    return static_cast<double>(valueAt<std::uint64_t>(bytes, order));
  case ScalarType::float32:
    return valueAt<float>(bytes, order);
  case ScalarType::float64:
    break;
  }
  return valueAt<double>(bytes, order);
}

/// Writes `value` over the bytes at `bytes`, aligned or not. pre: sizeof(T) bytes are there
template <class T> void setValueAt(char* bytes, T value, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
      std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  std::memcpy(bytes, raw.data(), sizeof(T));
}

/// Appends `value` to `bytes`.
template <class T>
void appendValue(std::string& bytes, T value, std::endian order = std::endian::little) {
  bytes.resize(bytes.size() + sizeof(T));
  setValueAt(bytes.data() + bytes.size() - sizeof(T), value, order);
}

} // namespace espalier
