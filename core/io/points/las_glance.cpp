// What LAS and LAZ files say of themselves.
#include "core/base/text.h"
#include "core/io/bytes/scalar.h"
#include "core/io/points/las_header.h"
#include "core/io/points/las_points.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"

#include <algorithm>

namespace espalier {
namespace {

constexpr std::uint64_t mostRecordBytes = std::uint64_t{1} << 24; // of all, that are looked at

/// The unit that a GeoTIFF code stands for, as a sentence ends with it.
GlanceGuess unitOfCode(std::uint16_t code) {
  switch (code) {
  case 9001:
    return {"m", {Shown::tr("its map projection is in meters")}, true};
  case 9002:
  case 9003:
    return {"",
            {Shown::tr("its map projection is in feet, which have no name here: lengths are shown "
                       "without a unit")},
            true};
  default:
    return {};
  }
}

GlanceGuess unitOfKeys(std::string_view keys) {
  constexpr std::uint16_t linearUnits = 3076; // ProjLinearUnitsGeoKey
  constexpr std::size_t keySize = 8;
  for (std::size_t at = keySize; at + keySize <= keys.size(); at += keySize)
    if (valueAt<std::uint16_t>(keys.data() + at) == linearUnits)
      return unitOfCode(valueAt<std::uint16_t>(keys.data() + at + 6));
  return {};
}

GlanceGuess unitOfWkt(std::string_view wkt) {
  const std::string text = lowerCase(wkt);
  if (!text.starts_with("proj") && !text.starts_with("compd")) return {}; // degrees
  for (const char* name : {"unit[\"metre\"", "unit[\"meter\"", "unit[\"m\""})
    if (text.find(name) != std::string::npos) return unitOfCode(9001);
  return text.find("foot") != std::string::npos ? unitOfCode(9002) : GlanceGuess{};
}

GlanceGuess unitOfLas(std::string_view head, const LasHeader& header) {
  const GlanceGuess byKeys = unitOfKeys(lasRecord(head, header, "LASF_Projection", 34735));
  return byKeys.isStated ? byKeys : unitOfWkt(lasRecord(head, header, "LASF_Projection", 2112));
}

Eigen::AlignedBox3d boundsOfLas(std::string_view head) {
  constexpr std::size_t boundsStart = 179; // greatest and least x, then y, then z
  Eigen::AlignedBox3d box;
  Eigen::Vector3d least;
  Eigen::Vector3d most;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char* at = head.data() + boundsStart + 16 * axis;
    most[static_cast<Eigen::Index>(axis)] = valueAt<double>(at);
    least[static_cast<Eigen::Index>(axis)] = valueAt<double>(at + 8);
  }
  if (least.isZero(0) && most.isZero(0)) return box; // never filled in
  if (!least.allFinite() || !most.allFinite() || (least.array() > most.array()).any()) return box;
  return {least, most};
}

std::vector<GlanceColumn> columnsOfLas(const LasHeader& header) {
  std::vector<GlanceColumn> columns;
  for (const char* name : {"x", "y", "z"})
    columns.push_back({name, "scaled int32", true});
  columns.push_back({"intensity", "uint16", true});
  columns.push_back({"returns, flags, class, angle", "bits", false});
  const std::size_t format = header.format;
  if (format != 0 && format != 2) columns.push_back({"gps_time", "double", false});
  if (header.colorStart() > 0)
    for (const char* name : {"red", "green", "blue"})
      columns.push_back({name, "uint16", true});
  if (format == 8 || format == 10) columns.push_back({"near_infrared", "uint16", false});
  if (format == 4 || format == 5 || format >= 9) columns.push_back({"waveform", "bytes", false});
  return columns;
}

/// Those that are read: without what is flagged as withheld.
void sampleLas(ByteSource& source, const LasHeader& header, PointGlance& glance) {
  sampleRecords(
      source, header.pointStart, header.pointLength, header.count, [&](const char* bytes) {
        const LasPoint point = lasPointAt(bytes, header);
        if (point.isWithheld) return;
        const Eigen::Vector3d steps(point.position[0], point.position[1], point.position[2]);
        glance.sample.emplace_back(header.offset + header.scale.cwiseProduct(steps));
      });
}

} // namespace

PointGlance glanceAtLas(ByteSource& source, const std::string& file) {
  std::string head = source.read(0, longestLasHeader);
  const LasHeader header = readLasHeader(head, source.size(), file);
  head = source.read(0, std::min(header.pointStart, mostRecordBytes));
  PointGlance glance;
  glance.isCompressed = isLaz(head);
  const bool isCopc = !lasRecord(head, header, "copc", 1).empty();
  glance.version = {
      Shown::tr("%1, point format %2"),
      {std::string(isCopc ? "COPC, LAS " : "LAS ") + "1." + std::to_string(header.minorVersion),
       std::to_string(header.format)}};
  glance.points = header.count;
  glance.columns = columnsOfLas(header);
  if (header.count > 0) glance.bounds = boundsOfLas(head);
  glance.unit = unitOfLas(head, header);
  if (!glance.isCompressed) sampleLas(source, header, glance);
  glance.up = {"z", {Shown::tr("LAS has heights along z")}, true};
  return glance;
}

} // namespace espalier
