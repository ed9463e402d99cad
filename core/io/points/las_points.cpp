#include "core/io/points/las_points.h"

#include "core/io/bytes/scalar.h"

#include <utility>
#include <vector>

namespace espalier {
namespace {

std::vector<PointField> fieldsOf(const LasHeader& header) {
  using enum PointField;
  if (header.colorStart() > 0) return {intensity, red, green, blue};
  return {intensity};
}

bool isWithheld(const char* bytes, const LasHeader& header) {
  if (header.format >= 6) return (valueAt<std::uint8_t>(bytes + 15) & 0x04) != 0;
  // The flag took its bit from the class in version 1.1.
  return header.minorVersion > 0 && (valueAt<std::uint8_t>(bytes + 15) & 0x80) != 0;
}

PointValues valuesOf(const LasPoint& point, const LasHeader& header) {
  PointValues values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    values[indexOf(PointField::x) + i] =
        point.position[i] * header.scale[axis] + header.offset[axis];
    values[indexOf(PointField::red) + i] = point.color[i];
  }
  values[indexOf(PointField::intensity)] = point.intensity;
  return values;
}

} // namespace

LasPoint lasPointAt(const char* bytes, const LasHeader& header) {
  LasPoint point;
  const std::size_t colorStart = header.colorStart();
  for (std::size_t i = 0; i < 3; ++i) {
    point.position[i] = valueAt<std::int32_t>(bytes + 4 * i);
    if (colorStart > 0) point.color[i] = valueAt<std::uint16_t>(bytes + colorStart + 2 * i);
  }
  point.intensity = valueAt<std::uint16_t>(bytes + 12);
  point.isWithheld = isWithheld(bytes, header);
  return point;
}

LasPoints::LasPoints(const LasHeader& header, std::uint64_t expected, PartChooser& chooser)
    : header_(header), chooser_(&chooser), points_(fieldsOf(header), expected, chooser) {}

void LasPoints::add(const LasPoint& point) {
  if (!point.isWithheld) return points_.add(valuesOf(point, header_));
  ++withheld_;
  chooser_->pass();
}

ImportedPoints LasPoints::finish(const std::string& file) && {
  ImportedPoints result{{std::move(points_).finish(false), {}}, header_.count};
  dropEmptyColumns(result.value);
  if (withheld_ > 0)
    result.notes.push_back({Shown::tr("%1 of %2 points are flagged as withheld and are left out"),
                            {std::to_string(withheld_), std::to_string(header_.count)},
                            FilePlace{file}});
  return result;
}

} // namespace espalier
