// What PLY files say of themselves.
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/points/ply_header.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"

#include <algorithm>
#include <array>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint64_t longestPlyHeader = std::uint64_t{1} << 20;

/// A column that is taken: where its value lies.
struct PlyPlace {
  std::size_t word = 0;  // of a line
  std::size_t start = 0; // in bytes of a row
  ScalarType type = ScalarType::float32;
};

/// The places of x, y and z, if the rows have all of them.
std::vector<PlyPlace> positionsIn(const PlyElement& element) {
  std::vector<PlyPlace> places;
  for (const PointField field : {PointField::x, PointField::y, PointField::z}) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (pointFieldNamed(property.name) == field && !property.countType) {
        places.push_back({i, start, property.type});
        break;
      }
      start += sizeOf(property.type);
    }
  }
  return places;
}

std::vector<GlanceColumn> columnsOf(const PlyElement& element) {
  std::vector<GlanceColumn> columns;
  std::array<bool, PointValues().size()> isThere{};
  for (const PlyProperty& property : element.properties) {
    const PointField field = property.countType ? PointField::none : pointFieldNamed(property.name);
    const bool isTaken = field != PointField::none && field != PointField::packedColor &&
                         !std::exchange(isThere[indexOf(field)], true);
    columns.push_back(
        {property.name, property.countType ? "list" : std::string(nameOf(property.type)), isTaken});
  }
  return columns;
}

void samplePly(ByteSource& source, const PlyHeader& header, const PlyElement& vertices,
               PointGlance& glance) {
  const std::vector<PlyPlace> places = positionsIn(vertices);
  const bool comeFirst = &vertices == header.elements.data();
  if (places.size() != 3 || !comeFirst || vertices.hasLists()) return;
  Eigen::Vector3d position;
  if (!header.isAscii) {
    sampleRecords(source, header.dataStart, vertices.leastSize(), vertices.count,
                  [&](const char* row) {
                    for (Eigen::Index axis = 0; axis < 3; ++axis) {
                      const PlyPlace& place = places[static_cast<std::size_t>(axis)];
                      position[axis] = scalarAt(row + place.start, place.type, header.order);
                    }
                    glance.sample.push_back(position);
                  });
  } else if (header.elements.size() == 1) { // else lines of others may be met
    (void)sampleLines(source, header.dataStart, [&](std::string_view line) {
      std::vector<std::string_view> words;
      for (auto word = nextWord(line); !word.empty(); word = nextWord(line))
        words.push_back(word);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const std::size_t word = places[static_cast<std::size_t>(axis)].word;
        const auto number = word < words.size() ? numberIn(words[word]) : std::nullopt;
        if (!number) return false;
        position[axis] = *number;
      }
      glance.sample.push_back(position);
      return true;
    });
  }
}

} // namespace

PointGlance glanceAtPly(ByteSource& source, const std::string& file) {
  const PlyHeader header = readPlyHeader(source.read(0, longestPlyHeader), file);
  const auto vertices = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertices == header.elements.end())
    throw ShownError({Shown::tr("has no element 'vertex', so no points"), {}, FilePlace{file}});
  PointGlance glance;
  glance.version = {header.isAscii                     ? Shown::tr("text")
                    : header.order == std::endian::big ? Shown::tr("binary, big endian")
                                                       : Shown::tr("binary, little endian")};
  glance.points = vertices->count;
  glance.columns = columnsOf(*vertices);
  for (const PlyElement& element : header.elements)
    if (&element != &*vertices && element.count > 0)
      glance.leftOut.push_back(
          {Shown::tr("%1 of element %2"), {std::to_string(element.count), inQuotes(element.name)}});
  samplePly(source, header, *vertices, glance);
  return glance;
}

} // namespace espalier
