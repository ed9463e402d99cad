#include "tests/core/io/plantgl/pickle_writer.h"

#include "core/io/bytes/scalar.h"

#include <bit>

namespace espalier::test {
namespace {

std::string key(std::int64_t vertex) {
  return PickleWriter::integer(vertex);
}

template <class Values, class Write> std::string table(const Values& values, const Write& write) {
  std::string bytes = "}(";
  for (const auto& [vertex, value] : values)
    bytes += key(vertex) + write(value);
  return bytes + "u";
}

} // namespace

std::string PickleWriter::integer(std::int64_t value) {
  std::string bytes = "J";
  appendValue(bytes, static_cast<std::int32_t>(value));
  return bytes;
}

std::string PickleWriter::real(double value) {
  std::string bytes = "G";
  appendValue(bytes, value, std::endian::big);
  return bytes;
}

std::string PickleWriter::text(const std::string& value) {
  std::string bytes = "X";
  appendValue(bytes, static_cast<std::uint32_t>(value.size()));
  return bytes + value;
}

std::string PickleWriter::vector(double x, double y, double z) {
  return "copenalea.plantgl.math._pglmath\nVector3\n" + real(x) + real(y) + real(z) + "\x87R";
}

std::string pickled(const PickledMtg& mtg) {
  const auto text = [](const std::string& value) { return PickleWriter::text(value); };
  const auto integer = [](std::int64_t value) { return PickleWriter::integer(value); };
  std::string properties = "}(";
  properties += text("position") + table(mtg.positions, [](const std::array<double, 3>& position) {
                  return PickleWriter::vector(position[0], position[1], position[2]);
                });
  properties +=
      text("edge_type") + table(mtg.edges, text) + text("label") + table(mtg.labels, text);
  for (const auto& [name, values] : mtg.extra)
    properties += text(name) + table(values, [](const std::string& value) { return value; });
  std::string parents = table(mtg.parents, integer);
  parents += key(0) + "Ns"; // the scene has none
  return "\x80\x02"
         "copenalea.mtg.mtg\nMTG\n)\x81}(" +
         text("_scale") + table(mtg.scales, integer) + text("_parent") + parents +
         text("_complex") + table(mtg.complexes, integer) + text("_properties") + properties + "u" +
         text("_id") + integer(0) + "ub.";
}

PickledMtg pickledPlant() {
  PickledMtg mtg;
  mtg.scales = {{0, 0}, {1, 1}, {2, 2}, {3, 2}, {4, 2}, {5, 2}};
  mtg.parents = {{3, 2}, {4, 3}, {5, 3}};
  mtg.complexes = {{1, 0}, {2, 1}};
  mtg.labels = {{1, "P1"}, {2, "N"}, {3, "N"}, {4, "N12"}, {5, "N"}};
  mtg.edges = {{3, "<"}, {4, "<"}, {5, "+"}};
  mtg.positions = {{2, {0, 0, 0}}, {3, {0, 0, 1}}, {4, {0, 0, 2}}, {5, {1, 0, 1.5}}};
  return mtg;
}

std::string bmtgFile() {
  return pickled(pickledPlant());
}

} // namespace espalier::test
