#pragma once

#include "core/cloud/point_cloud.h"

#include <cstdint>
#include <string>
#include <vector>

namespace espalier::test {

/// Writes objects of a binary scene of PlantGL.
struct BgeomWriter {
  int version = 24; // 2.4
  int bits = 64;    // of reals

  /// Codes of the types: those that PlantGL takes for granted, and those of `file`.
  static constexpr char reference = 1;
  static constexpr char shape = 2;
  static constexpr char material = 3;
  static constexpr char group = 20;
  static constexpr char pointSet = 25;
  static constexpr char translated = 32;
  static constexpr char scaled = 40;
  static constexpr char sphere = 41;
  static constexpr char triangleSet = 42;
  static constexpr char axisRotated = 43;
  static constexpr char eulerRotated = 45;
  static constexpr char oriented = 46;
  static constexpr char tapered = 47;
  static constexpr char teapot = 44; // which PlantGL does not have

  [[nodiscard]] std::string reals(const std::vector<double>& values) const;
  [[nodiscard]] std::string begin(char type, std::uint32_t ident = 0) const; // name and ident
  [[nodiscard]] std::string points(const std::vector<double>& coordinates,
                                   const std::vector<Color>& colors = {},
                                   std::uint32_t ident = 0) const;
  [[nodiscard]] std::string defaultMaterial() const;
  [[nodiscard]] std::string shapeOf(const std::string& geometry) const;
  [[nodiscard]] std::string file(const std::string& objects) const;
};

/// A number of 32 bits, little-endian.
[[nodiscard]] std::string uint32Bytes(std::uint32_t value);

/// Two shapes: two colored points moved by (10, 0, 0), and a group of the same again and a sphere.
[[nodiscard]] std::string bgeomFile();

} // namespace espalier::test
