#include "tests/core/io/plantgl/bgeom_writer.h"

#include "core/io/bytes/scalar.h"

namespace espalier::test {

std::string uint32Bytes(std::uint32_t value) {
  std::string bytes;
  appendValue(bytes, value);
  return bytes;
}

std::string BgeomWriter::reals(const std::vector<double>& values) const {
  std::string bytes;
  for (const double value : values) {
    if (bits == 64)
      appendValue(bytes, value);
    else
      appendValue(bytes, static_cast<float>(value));
  }
  return bytes;
}

std::string BgeomWriter::begin(char type, std::uint32_t ident) const {
  std::string bytes(1, type);
  const std::string name = ident != 0 ? "shared" : "";
  appendValue(bytes, static_cast<std::uint16_t>(name.size()));
  bytes += name;
  if (version >= 20 || !name.empty()) bytes += uint32Bytes(ident);
  return bytes;
}

std::string BgeomWriter::points(const std::vector<double>& coordinates,
                                const std::vector<Color>& colors, std::uint32_t ident) const {
  std::string bytes = begin(pointSet, ident);
  bytes += uint32Bytes(static_cast<std::uint32_t>(coordinates.size() / 3)) + reals(coordinates);
  if (version >= 17) {
    bytes += uint32Bytes(static_cast<std::uint32_t>(colors.size()));
    for (const Color& color : colors) {
      for (const std::uint8_t channel : color)
        bytes += static_cast<char>(channel);
      bytes += '\0'; // alpha
    }
  }
  if (version >= 21) bytes += '\x02';
  return bytes;
}

std::string BgeomWriter::defaultMaterial() const {
  return begin(material) + "\xff";
}

std::string BgeomWriter::shapeOf(const std::string& geometry) const {
  std::string bytes(1, shape);
  bytes += std::string("\x04\0leaf", 6) + uint32Bytes(7);
  if (version >= 19) bytes += uint32Bytes(0xffffffff);
  return bytes + geometry + defaultMaterial();
}

std::string BgeomWriter::file(const std::string& objects) const {
  std::string bytes = "!bGEOM";
  appendValue(bytes, static_cast<float>(version) / 10);
  if (version >= 11) bytes += "\r\n";
  if (version >= 16) bytes += static_cast<char>(bits);
  bytes += "#of a test#!";
  const std::vector<std::pair<char, std::string>> types = {{scaled, "Scaled"},
                                                           {sphere, "Sphere"},
                                                           {triangleSet, "TriangleSet"},
                                                           {axisRotated, "AxisRotated"},
                                                           {eulerRotated, "EulerRotated"},
                                                           {oriented, "Oriented"},
                                                           {tapered, "Tapered"},
                                                           {teapot, "Teapot"}};
  bytes += uint32Bytes(static_cast<std::uint32_t>(types.size()));
  for (const auto& [code, name] : types) {
    bytes += code;
    appendValue(bytes, static_cast<std::uint16_t>(name.size()));
    bytes += name + uint32Bytes(1);
  }
  return bytes + "!" + uint32Bytes(1) + objects;
}

std::string bgeomFile() {
  const BgeomWriter out;
  const std::string points = out.points({1, 2, 3, 4, 5, 6}, {{10, 20, 30}, {40, 50, 60}}, 5);
  const std::string moved = out.begin(BgeomWriter::translated) + out.reals({10, 0, 0}) + points;
  const std::string sphere = out.begin(BgeomWriter::sphere) + "\x06" + out.reals({0.5});
  const std::string group = out.begin(BgeomWriter::group) + "\xff" + uint32Bytes(2) +
                            BgeomWriter::reference + uint32Bytes(5) + sphere;
  return out.file(out.shapeOf(moved) + out.shapeOf(group));
}

} // namespace espalier::test
