// What PCD files say of themselves.
#include "core/base/text.h"
#include "core/io/points/pcd_header.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"

#include <array>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint64_t longestPcdHeader = std::uint64_t{1} << 16;

struct PcdPlace {
  bool isThere = false;
  std::size_t word = 0;  // of a line
  std::size_t start = 0; // in bytes of a point
  ScalarType type = ScalarType::float32;
};

void samplePcd(ByteSource& source, const PcdHeader& header, const std::array<PcdPlace, 3>& places,
               PointGlance& glance) {
  Eigen::Vector3d position;
  for (const PcdPlace& place : places)
    if (!place.isThere) return;
  const auto take = [&](const auto& valueAtPlace) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::optional<double> value = valueAtPlace(places[static_cast<std::size_t>(axis)]);
      if (!value) return false;
      position[axis] = *value;
    }
    glance.sample.push_back(position);
    return true;
  };
  if (header.data == PcdData::binary)
    sampleRecords(source, header.dataStart, header.pointSize(), header.points,
                  [&](const char* point) {
                    take([&](const PcdPlace& place) -> std::optional<double> {
                      return scalarAt(point + place.start, place.type);
                    });
                  });
  if (header.data == PcdData::ascii)
    (void)sampleLines(source, header.dataStart, [&](std::string_view line) {
      std::vector<std::string_view> words;
      for (auto word = nextWord(line); !word.empty(); word = nextWord(line))
        words.push_back(word);
      return take([&](const PcdPlace& place) -> std::optional<double> {
        return place.word < words.size() ? numberIn(words[place.word]) : std::nullopt;
      });
    });
}

} // namespace

PointGlance glanceAtPcd(ByteSource& source, const std::string& file) {
  const PcdHeader header = readPcdHeader(source.read(0, longestPcdHeader), file);
  PointGlance glance;
  glance.version = {header.data == PcdData::ascii ? Shown::tr("text") : Shown::tr("binary")};
  glance.isCompressed = header.data == PcdData::compressed;
  glance.points = header.points;
  std::array<PcdPlace, 3> places;
  std::array<bool, PointValues().size()> isThere{};
  std::size_t start = 0;
  std::size_t word = 0;
  for (const PcdField& field : header.fields) {
    const PointField role = field.count > 0 ? pointFieldNamed(field.name) : PointField::none;
    const bool isTaken = role != PointField::none && !std::exchange(isThere[indexOf(role)], true);
    glance.columns.push_back({field.name, std::string(nameOf(field.type)), isTaken});
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (isTaken && role == std::array{PointField::x, PointField::y, PointField::z}[axis])
        places[axis] = {true, word, start, field.type};
    start += field.size();
    word += field.count;
  }
  samplePcd(source, header, places, glance);
  return glance;
}

} // namespace espalier
