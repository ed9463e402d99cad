#include "core/io/points/point_collector.h"

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

struct NamedField {
  std::string_view name;
  PointField field;
};

constexpr auto namedFields = std::to_array<NamedField>({
    {"x", PointField::x},
    {"y", PointField::y},
    {"z", PointField::z},
    {"xx", PointField::x},
    {"yy", PointField::y},
    {"zz", PointField::z},
    {"intensity", PointField::intensity},
    {"i", PointField::intensity},
    {"scalar_intensity", PointField::intensity},
    {"reflectance", PointField::intensity},
    {"scalar_reflectance", PointField::intensity},
    {"red", PointField::red},
    {"green", PointField::green},
    {"blue", PointField::blue},
    {"r", PointField::red},
    {"g", PointField::green},
    {"b", PointField::blue},
    {"diffuse_red", PointField::red},
    {"diffuse_green", PointField::green},
    {"diffuse_blue", PointField::blue},
    {"rgb", PointField::packedColor},
    {"rgba", PointField::packedColor},
    {"station", PointField::station},
    {"scalar_station", PointField::station},
});

/// By what colors of this size are multiplied to become bytes.
double colorScale(float largest, bool mayBeFractions) {
  if (largest <= 1 && mayBeFractions) return 255;
  return largest <= 255 ? 1 : 1.0 / 256; // 16 bits: 256 v and 257 v both stand for v
}

std::uint8_t byteOf(double value) {
  if (!(value > 0)) return 0;
  return static_cast<std::uint8_t>(std::min(value, 255.0));
}

} // namespace

PointField pointFieldNamed(std::string_view name) {
  const std::string key = lowerCase(name);
  const auto* found = std::ranges::find(namedFields, key, &NamedField::name);
  return found == namedFields.end() ? PointField::none : found->field;
}

PointCollector::PointCollector(const std::vector<PointField>& fields, std::size_t expected) {
  const auto has = [&](PointField field) { return std::ranges::count(fields, field) > 0; };
  hasPackedColors_ = has(PointField::packedColor);
  hasColors_ =
      hasPackedColors_ || (has(PointField::red) && has(PointField::green) && has(PointField::blue));
  hasIntensities_ = has(PointField::intensity);
  hasStations_ = has(PointField::station);
  points_.positions.reserve(expected);
  if (hasColors_) colors_.reserve(expected);
  if (hasIntensities_) points_.intensities.reserve(expected);
  if (hasStations_) points_.stationOf.reserve(expected);
}

void PointCollector::add(const PointValues& values) {
  const auto value = [&](PointField field) { return values[indexOf(field)]; };
  points_.positions.emplace_back(value(PointField::x), value(PointField::y), value(PointField::z));
  if (hasIntensities_)
    points_.intensities.push_back(static_cast<float>(value(PointField::intensity)));
  if (hasStations_) {
    const double number = value(PointField::station);
    hasStations_ = number >= 0 && number < mostStations && std::floor(number) == number;
    points_.stationOf.push_back(hasStations_ ? static_cast<StationIndex>(number) : 0);
  }
  if (hasPackedColors_) {
    const double number = value(PointField::packedColor);
    const bool isPacked = number >= 0 && number <= 0xffffffff;
    const std::uint32_t packed = isPacked ? static_cast<std::uint32_t>(number) : 0;
    colors_.push_back({static_cast<float>(packed >> 16 & 255),
                       static_cast<float>(packed >> 8 & 255), static_cast<float>(packed & 255)});
  } else if (hasColors_) {
    colors_.push_back({static_cast<float>(value(PointField::red)),
                       static_cast<float>(value(PointField::green)),
                       static_cast<float>(value(PointField::blue))});
  }
}

void PointCollector::nameStations(std::vector<Station> stations) {
  std::vector<StationIndex>& stationOf = points_.stationOf;
  if (!hasStations_) {
    stationOf.clear();
    if (stations.size() == 1) points_.stations = std::move(stations);
    return;
  }
  if (stationOf.empty()) return;
  if (*std::ranges::max_element(stationOf) >= stations.size()) {
    std::vector<StationIndex> numbers(stationOf);
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    std::vector<StationIndex> places(std::size_t{numbers.back()} + 1);
    stations.clear();
    for (const StationIndex number : numbers) {
      places[number] = static_cast<StationIndex>(stations.size());
      stations.push_back({.name = "station " + std::to_string(number), .scanner = {}});
    }
    for (StationIndex& station : stationOf)
      station = places[station];
  }
  if (stations.size() == 1) stationOf.clear();
  points_.stations = std::move(stations);
}

RawPoints PointCollector::finish(bool mayBeFractions, std::vector<Station> stations) && {
  nameStations(std::move(stations));
  float largest = 0;
  for (const auto& color : colors_)
    for (const float value : color)
      largest = std::max(largest, value);
  const double scale = colorScale(largest, mayBeFractions && !hasPackedColors_);
  const double rounding = scale > 1 ? 0.5 : 0;
  points_.colors.reserve(colors_.size());
  for (const auto& color : colors_)
    points_.colors.push_back({byteOf(color[0] * scale + rounding),
                              byteOf(color[1] * scale + rounding),
                              byteOf(color[2] * scale + rounding)});
  return std::move(points_);
}

void dropEmptyColumns(RawPoints& points) {
  if (std::ranges::all_of(points.intensities, [](float value) { return value == 0; }))
    points.intensities.clear();
  if (std::ranges::all_of(points.colors, [](const Color& color) { return color == Color{}; }))
    points.colors.clear();
}

void checkPromise(const std::string& file, std::uint64_t count, std::uint64_t size,
                  std::uint64_t available) {
  if (count > available / size)
    throw Error(file + ": its header promises " + counted(count, "point") + " of at least " +
                counted(size, "byte") + ", but only " + counted(available, "byte") +
                " follow: the file is cut short or damaged, copy or export it again");
  checkPointCount(file, count);
}

void checkPointCount(const std::string& file, std::uint64_t count) {
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw Error(file + ": holds " + std::to_string(count) +
                " points, more than can be worked on at once: thin or split it");
}

} // namespace espalier
