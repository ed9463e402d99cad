#include "core/io/points/point_collector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

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

PointCollector::PointCollector(const std::vector<PointField>& fields, std::uint64_t expected,
                               PartChooser& chooser)
    : chooser_(&chooser) {
  const auto has = [&](PointField field) { return std::ranges::count(fields, field) > 0; };
  hasPackedColors_ = has(PointField::packedColor);
  hasColors_ =
      hasPackedColors_ || (has(PointField::red) && has(PointField::green) && has(PointField::blue));
  hasIntensities_ = has(PointField::intensity);
  hasStations_ = has(PointField::station);
  const std::size_t room = chooser.roomFor(expected);
  points_.positions.reserve(room);
  if (chooser.isLimited()) ranks_.reserve(room);
  if (hasColors_) colors_.reserve(room);
  if (hasIntensities_) points_.intensities.reserve(room);
  if (hasStations_) points_.stationOf.reserve(room);
}

void PointCollector::add(const PointValues& values) {
  const auto value = [&](PointField field) { return values[indexOf(field)]; };
  if (hasColors_ && !hasPackedColors_)
    for (const PointField field : {PointField::red, PointField::green, PointField::blue})
      largestColor_ = std::max(largestColor_, static_cast<float>(value(field)));
  const double number = value(PointField::station);
  if (hasStations_)
    hasStations_ = number >= 0 && number < mostStations && std::floor(number) == number;
  const Eigen::Vector3d position(value(PointField::x), value(PointField::y), value(PointField::z));
  const auto rank = chooser_->offer(position);
  if (!rank) return;
  points_.positions.push_back(position);
  if (chooser_->isLimited()) ranks_.push_back(*rank);
  if (hasIntensities_)
    points_.intensities.push_back(static_cast<float>(value(PointField::intensity)));
  if (hasStations_) points_.stationOf.push_back(static_cast<StationIndex>(number));
  if (hasColors_) addColor(values);
  if (chooser_->areMany(size())) reduce();
}

void PointCollector::addColor(const PointValues& values) {
  if (!hasPackedColors_) {
    colors_.push_back({static_cast<float>(values[indexOf(PointField::red)]),
                       static_cast<float>(values[indexOf(PointField::green)]),
                       static_cast<float>(values[indexOf(PointField::blue)])});
    return;
  }
  const double number = values[indexOf(PointField::packedColor)];
  const bool isPacked = number >= 0 && number <= 0xffffffff;
  const std::uint32_t packed = isPacked ? static_cast<std::uint32_t>(number) : 0;
  colors_.push_back({static_cast<float>(packed >> 16 & 255), static_cast<float>(packed >> 8 & 255),
                     static_cast<float>(packed & 255)});
}

void PointCollector::reduce() {
  if (!chooser_->isLimited()) return;
  chooser_->learn(ranks_);
  if (!hasStations_) points_.stationOf.clear(); // of some points alone
  keepThoseThatStay(colors_, ranks_, *chooser_);
  keepThoseThatStay(points_, ranks_, *chooser_);
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
  if (chooser_->isPart()) dropEmptyStations(points_);
}

RawPoints PointCollector::finish(bool mayBeFractions, std::vector<Station> stations) && {
  reduce();
  nameStations(std::move(stations));
  const double scale = hasPackedColors_ ? 1 : colorScale(largestColor_, mayBeFractions);
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

void checkPromise(const FilePlace& where, std::uint64_t count, std::uint64_t size,
                  std::uint64_t available) {
  if (count > available / size)
    throw ShownError(
        {Shown::tr("its header promises %1 points of at least %2 bytes, but only %3 bytes follow: "
                   "the file is cut short or damaged, copy or export it again"),
         {std::to_string(count), std::to_string(size), std::to_string(available)},
         where});
  checkPointCount(where, count);
}

ShownError becameShorter(const std::string& file) {
  return ShownError(
      {Shown::tr("became shorter while it was read: wait until it is complete, and try again"),
       {},
       FilePlace{file}});
}

void checkPointCount(const FilePlace& where, std::uint64_t count) {
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw ShownError(
        {Shown::tr("holds %1 points, more than can be worked on at once: thin or split it"),
         {std::to_string(count)},
         where});
}

} // namespace espalier
