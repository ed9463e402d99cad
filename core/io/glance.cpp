#include "core/io/glance.h"

#include "core/base/coordinates.h"
#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/graph/likely_up.h"
#include "core/io/formats.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace espalier {
namespace {

constexpr std::size_t mostSampled = 20'000;

/// Of formats that say nothing of themselves.
PointGlance glanceByReading(const std::filesystem::path& path) {
  const PointCloud cloud = readPoints(path).value;
  PointGlance glance;
  glance.isReadWhole = true;
  glance.points = static_cast<std::uint64_t>(cloud.size());
  glance.bounds = cloud.bounds();
  for (const char* name : {"x", "y", "z"})
    glance.columns.push_back({name, "", true});
  if (!cloud.intensities().empty()) glance.columns.push_back({"intensity", "", true});
  if (!cloud.colors().empty())
    for (const char* name : {"red", "green", "blue"})
      glance.columns.push_back({name, "", true});
  const Eigen::Index step = cloud.size() / static_cast<Eigen::Index>(mostSampled) + 1;
  for (Eigen::Index point = 0; point < cloud.size(); point += step)
    glance.sample.push_back(cloud.position(point));
  return glance;
}

/// The bounds of the sample, where the file states none.
void addBounds(PointGlance& glance) {
  if (!glance.bounds.isEmpty()) return;
  for (const Eigen::Vector3d& place : glance.sample)
    if (isInRange(place)) glance.bounds.extend(place);
  glance.areBoundsOfSample =
      glance.arePointsEstimated || glance.sample.size() < static_cast<std::size_t>(glance.points);
}

std::string roundedText(double value) {
  return plainDecimal(value < 100 ? std::round(value * 10) / 10 : std::round(value));
}

/// Whether places are those of a map rather than of a scanner: far from 0, 0 for their size.
bool areOfAMap(const Eigen::AlignedBox3d& bounds) {
  constexpr double farAway = 1e5;
  return bounds.center().head<2>().norm() > std::max(farAway, 100 * bounds.sizes().maxCoeff());
}

GlanceGuess guessedUnit(const Eigen::AlignedBox3d& bounds) {
  const std::string unit = unitOfBounds(bounds);
  if (!bounds.isEmpty() && areOfAMap(bounds))
    return {unit, {Shown::tr("coordinates so far from 0 are those of a map")}, false};
  const double extent = bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff();
  const std::string size = roundedText(extent);
  if (unit.empty() && extent > 1)
    return {"",
            {Shown::tr("it would be %1 m, %1 cm or %1 mm large: choose which it is"), {size}},
            false};
  if (unit.empty()) return {"", {Shown::tr("the size does not show it")}, false};
  if (unit == "mm")
    return {unit, {Shown::tr("in m it would be %1 m large, as no plant is"), {size}}, false};
  return {unit, {Shown::tr("in mm it would be %1 mm large, as few plants are"), {size}}, false};
}

GlanceGuess guessedUp(const std::vector<Eigen::Vector3d>& sample) {
  const auto up = likelyUp(sample);
  if (!up) return {"z", {Shown::tr("as most scans have it; no foot of a plant is seen")}, false};
  const std::string axis(1, "xyz"[static_cast<int>(*up)]);
  return {
      axis, {Shown::tr("at the low end of %1 points stand together, as at a foot"), {axis}}, false};
}

void requirePoints(const Format& format, const std::string& name) {
  if (format.content != Content::points)
    throw ShownError({Shown::tr("holds a structure (%1), not points: choose a scan"),
                      {std::string(format.name)},
                      FilePlace{name}});
}

} // namespace

std::string unitOfBounds(const Eigen::AlignedBox3d& bounds) {
  constexpr double highest = 100; // of trees [m]
  constexpr double usual = 40;    // higher ones are few: it may be a seedling in mm
  if (bounds.isEmpty()) return {};
  if (areOfAMap(bounds)) return "m";
  const double extent = bounds.sizes().maxCoeff();
  if (extent > highest) return "mm";
  return extent > 0.05 && extent <= usual ? "m" : "";
}

PointGlance glanceAt(const std::filesystem::path& path, const std::vector<PointField>& columns) {
  const Format& format = formatOf(path);
  const std::string name = path.string();
  requirePoints(format, name);
  std::ifstream in = openForReading(path);
  ByteSource source(in);
  requireColumnsFit(path, format, columns);
  PointGlance glance = format.glanceByColumns ? format.glanceByColumns(source, name, columns)
                       : format.glance        ? format.glance(source, name)
                                              : glanceByReading(path);
  addBounds(glance);
  if (!glance.unit.isStated) glance.unit = guessedUnit(glance.bounds);
  if (!glance.up.isStated) glance.up = guessedUp(glance.sample);
  return glance;
}

std::optional<FirstLines> firstLinesAt(const std::filesystem::path& path) {
  const Format& format = formatOf(path);
  const std::string name = path.string();
  requirePoints(format, name);
  if (format.glanceByColumns == nullptr) return std::nullopt;
  std::ifstream in = openForReading(path);
  ByteSource source(in);
  return firstLinesOf(source, name);
}

} // namespace espalier
