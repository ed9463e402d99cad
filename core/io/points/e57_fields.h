#pragma once

#include "core/io/bytes/xml.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What a field of the records of an E57 file is to a point.
enum class E57Role : std::uint8_t {
  none,
  x,
  y,
  z,
  range,
  azimuth,
  elevation,
  invalidPosition, // 0: the position is measured
  intensity,
  invalidIntensity,
  red,
  green,
  blue,
  invalidColor,
  count
};

[[nodiscard]] constexpr std::size_t indexOf(E57Role role) {
  return static_cast<std::size_t>(role);
}

/// From the smallest value to the largest.
struct E57Limits {
  double least = 0;
  double most = 0;

  [[nodiscard]] bool areSensible() const { return most > least && most - least <= 65535; }
};

/// A field of the records of an E57 file, and how its values are packed.
struct E57Field {
  enum class Kind : std::uint8_t { integer, float32, float64, text };

  E57Role role = E57Role::none;
  Kind kind = Kind::float64;
  unsigned bits = 64;       // of a value; 0 if all are the same, and for texts
  std::int64_t minimum = 0; // of integers: what is packed is how far values are above it
  double scale = 1;         // an integer i stands for offset + scale i
  double offset = 0;
  std::optional<E57Limits> limits; // where stated
};

/// The fields that a prototype describes, in the order of their streams: those that are needed for
/// points with their role, others with none. Positions are Cartesian if there are x, y and z, else
/// spherical.
/// @throws Error naming the line of the XML if a field is not as E57 1.0 has them, or if no
/// position
///               is among them
[[nodiscard]] std::vector<E57Field> e57FieldsOf(const XmlFile& xml, pugi::xml_node prototype);

/// The values of a field. They are packed one after another with the lowest bit first, through all
/// pieces of the stream: a value may begin in one piece and end in another.
class E57Stream {
public:
  explicit E57Stream(const E57Field& field) : field_(field) {}

  /// Takes a copy of the next piece; what was read of those before is given up.
  void add(std::string_view piece);

  /// How many values can be read now; of fields without bits as many as one likes.
  [[nodiscard]] std::uint64_t ready() const;
  /// How many values were added; pre: they have bits
  [[nodiscard]] std::uint64_t values() const { return bits_ / field_.bits; }

  /// pre: ready() > 0
  [[nodiscard]] double next();

private:
  [[nodiscard]] std::uint64_t take(unsigned bits);
  [[nodiscard]] std::uint64_t takeBytewise(unsigned bits);

  E57Field field_;
  std::string bytes_;
  std::uint64_t bits_ = 0; // in all pieces that were added
  std::size_t bit_ = 0;    // of `bytes_`, where the next value begins
};

} // namespace espalier
