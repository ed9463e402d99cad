#include "tests/core/io/qsm/mat_writer.h"

#include "core/io/bytes/scalar.h"

#include <gtest/gtest.h>

#include <zlib.h>

namespace espalier::test {
namespace {

constexpr std::uint32_t int8Type = 1;
constexpr std::uint32_t int32Type = 5;
constexpr std::uint32_t uint32Type = 6;
constexpr std::uint32_t matrixType = 14;
constexpr std::uint32_t compressedType = 15;
constexpr std::size_t nameSize = 32; // of a field

std::string tagged(std::uint32_t type, std::string data) {
  std::string bytes;
  appendValue(bytes, type);
  appendValue(bytes, static_cast<std::uint32_t>(data.size()));
  data.resize((data.size() + 7) / 8 * 8);
  return bytes + data;
}

std::string words(const std::vector<std::uint32_t>& values) {
  std::string bytes;
  for (const std::uint32_t value : values)
    appendValue(bytes, value);
  return bytes;
}

/// What begins a matrix: its class, size and name.
std::string head(std::uint32_t classType, std::uint32_t rows, std::uint32_t columns,
                 const std::string& name) {
  return tagged(uint32Type, words({classType, 0})) + tagged(int32Type, words({rows, columns})) +
         tagged(int8Type, name);
}

void appendNumber(std::string& bytes, double value, MatType type) {
  switch (type) {
  case MatType::int8:
    return appendValue(bytes, static_cast<std::int8_t>(value));
  case MatType::uint16:
    return appendValue(bytes, static_cast<std::uint16_t>(value));
  case MatType::uint32:
    return appendValue(bytes, static_cast<std::uint32_t>(value));
  case MatType::single:
    return appendValue(bytes, static_cast<float>(value));
  case MatType::real:
    break;
  }
  appendValue(bytes, value);
}

std::uint32_t classOf(MatType type) {
  switch (type) {
  case MatType::int8:
    return 8;
  case MatType::uint16:
    return 11;
  case MatType::uint32:
    return 13;
  case MatType::single:
    return 7;
  case MatType::real:
    break;
  }
  return 6;
}

/// A stream of zlib (RFC 1950).
std::string packed(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string bytes(size, '\0');
  const int status = compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                              reinterpret_cast<const Bytef*>(data.data()), data.size());
  EXPECT_EQ(status, Z_OK);
  bytes.resize(size);
  return bytes;
}

} // namespace

std::string matElement(const MatNumbers& numbers, const std::string& name) {
  std::string data;
  for (const double value : numbers.values)
    appendNumber(data, value, numbers.type);
  return tagged(matrixType, head(classOf(numbers.type), numbers.rows, numbers.columns, name) +
                                tagged(static_cast<std::uint32_t>(numbers.type), data));
}

std::string matStruct(const std::string& name, const MatFields& fields, std::uint32_t count) {
  std::string names;
  std::string elements;
  for (const auto& [field, element] : fields) {
    names += field + std::string(nameSize - field.size(), '\0');
    elements += element;
  }
  std::string body =
      head(2, 1, count, name) + words({4U << 16 | int32Type, nameSize}) + tagged(int8Type, names);
  for (std::uint32_t i = 0; i < count; ++i)
    body += elements;
  return tagged(matrixType, body);
}

std::string matFile(const std::vector<std::string>& elements, bool isCompressed) {
  std::string bytes = "MATLAB 5.0 MAT-file, of a test";
  bytes.resize(124, ' ');
  appendValue(bytes, std::uint16_t{0x0100});
  bytes += "IM";
  for (const std::string& element : elements) {
    if (!isCompressed) {
      bytes += element;
      continue;
    }
    const std::string stream = packed(element);
    bytes += words({compressedType, static_cast<std::uint32_t>(stream.size())}) + stream;
  }
  return bytes;
}

std::vector<std::pair<std::string, MatNumbers>> qsmFields() {
  using enum MatType;
  return {{"radius", {4, 1, {0.2, 0.1, 0.05, 0.04}, real}},
          {"length", {4, 1, {2, 1, 1, 0.5}}},
          {"start", {4, 3, {0, 0, 0, 0, 0, 0, 0.2, 1.2, 0, 2, 2, 2}, real}},
          {"axis", {4, 3, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0}}},
          {"parent", {4, 1, {0, 1, 1, 3}, uint16}},
          {"extension", {4, 1, {2, 0, 4, 0}, uint32}},
          {"added", {4, 1, {0, 0, 0, 1}, int8}},
          {"branch", {4, 1, {1, 1, 2, 2}, uint16}},
          {"BranchOrder", {4, 1, {0, 0, 1, 1}, int8}}};
}

MatFields elementsOf(const std::vector<std::pair<std::string, MatNumbers>>& fields) {
  MatFields elements;
  for (const auto& [name, numbers] : fields)
    elements.emplace_back(name, matElement(numbers));
  return elements;
}

std::string qsmMatFile() {
  const std::string cylinder = matStruct("", elementsOf(qsmFields()));
  return matFile({matStruct("QSM", {{"cylinder", cylinder}})}, true);
}

} // namespace espalier::test
