#include "core/cloud/joined_clouds.h"

#include "core/base/shown_message.h"
#include "core/cloud/file_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace espalier {
namespace {

std::vector<Station> stationsOf(const PlacedCloud& placed) {
  std::vector<Station> stations = placed.cloud->stations();
  if (stations.empty()) stations.push_back({.name = placed.name, .scanner = std::nullopt});
  for (Station& station : stations)
    if (station.scanner) station.scanner = placed.motion * *station.scanner;
  return stations;
}

void append(RawPoints& all, const PlacedCloud& placed, std::size_t firstStation,
            const Progress& progress) {
  const PointCloud& cloud = *placed.cloud;
  for (const Eigen::Index point : pointsInFileOrder(cloud, progress)) {
    if (all.positions.size() % 65536 == 0) progress.check();
    const auto i = static_cast<std::size_t>(point);
    all.positions.push_back(placed.motion * cloud.position(point));
    if (!cloud.colors().empty()) all.colors.push_back(cloud.colors()[i]);
    if (!cloud.intensities().empty()) all.intensities.push_back(cloud.intensities()[i]);
    all.stationOf.push_back(static_cast<StationIndex>(firstStation + cloud.stationOf(point)));
  }
}

} // namespace

PointCloud joined(const std::vector<PlacedCloud>& clouds, const Progress& progress) {
  RawPoints all;
  std::size_t points = 0;
  for (const PlacedCloud& placed : clouds)
    points += static_cast<std::size_t>(placed.cloud->size());
  if (points > std::numeric_limits<std::uint32_t>::max())
    throw ShownError(
        {Shown::tr("the scans have over 4 294 967 295 points together: thin them first")});
  all.positions.reserve(points);
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::size_t firstStation = all.stations.size();
    for (Station& station : stationsOf(clouds[i]))
      all.stations.push_back(std::move(station));
    if (all.stations.size() > mostStations)
      throw ShownError(
          {Shown::tr("the scans have over 65536 stations together: join fewer of them")});
    const auto share = [&](std::size_t cloud) {
      return 0.4 * static_cast<double>(cloud) / static_cast<double>(clouds.size());
    };
    append(all, clouds[i], firstStation, progress.part(share(i), share(i + 1)));
  }
  if (all.colors.size() != points) all.colors.clear();
  if (all.intensities.size() != points) all.intensities.clear();
  if (all.stations.size() < 2) all.stationOf.clear();
  return PointCloud(std::move(all), progress.part(0.4, 1));
}

} // namespace espalier
