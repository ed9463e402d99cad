#include "core/io/points/station_points.h"

#include "core/base/coordinates.h"
#include "core/io/points/point_collector.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// Appends the values of a station, or as many empty ones as it has points; both lists may be
/// empty: then nothing is known so far.
template <class Value>
void appendOrFill(std::vector<Value>& all, const std::vector<Value>& values, std::size_t before,
                  std::size_t points) {
  if (all.empty() && values.empty()) return;
  all.resize(before); // those of stations that had none
  all.insert(all.end(), values.begin(), values.end());
  all.resize(before + points);
}

} // namespace

void StationPoints::add(RawPoints points, const std::vector<std::uint64_t>& ranks,
                        Station station) {
  ++stations_;
  const std::size_t count = points.positions.size();
  if (count == 0) return;
  if (station.name.empty()) station.name = "station " + std::to_string(stations_);
  if (station.scanner && !isInRange(*station.scanner)) station.scanner.reset();
  named_.push_back(std::move(station));
  if (points.colors.empty()) ++uncolored_;
  if (points.intensities.empty()) ++unintense_;
  ranks_.insert(ranks_.end(), ranks.begin(), ranks.end());
  if (all_.positions.empty()) { // mostly there is one station: nothing is copied
    all_ = std::move(points);
    return;
  }
  const std::size_t before = all_.positions.size();
  appendOrFill(all_.colors, points.colors, before, count);
  appendOrFill(all_.intensities, points.intensities, before, count);
  all_.stationOf.resize(before); // those of the first
  all_.stationOf.resize(before + count,
                        static_cast<StationIndex>(std::min(named_.size(), mostStations) - 1));
  all_.positions.insert(all_.positions.end(), points.positions.begin(), points.positions.end());
  if (chooser_.areMany(all_.positions.size())) reduce();
}

void StationPoints::reduce() {
  if (!chooser_.isLimited()) return;
  chooser_.learn(ranks_);
  keepThoseThatStay(all_, ranks_, chooser_);
}

Imported<RawPoints> StationPoints::finish(const std::string& file) && {
  reduce();
  Imported<RawPoints> result{std::move(all_), {}};
  const RawPoints& points = result.value;
  dropEmptyColumns(result.value);
  if (named_.size() <= mostStations)
    result.value.stations = std::move(named_);
  else
    result.value.stationOf.clear();
  if (chooser_.isPart()) dropEmptyStations(result.value);
  const std::string stations = std::to_string(stations_);
  if (stations_ > 1)
    result.notes.push_back({Shown::tr("holds %1 stations, which are joined into one set of points"),
                            {stations},
                            FilePlace{file}});
  if (uncolored_ > 0 && !points.colors.empty())
    result.notes.push_back({Shown::tr("no colors in %1 of %2 stations: points there are black"),
                            {std::to_string(uncolored_), stations},
                            FilePlace{file}});
  if (unintense_ > 0 && !points.intensities.empty())
    result.notes.push_back(
        {Shown::tr("no intensities in %1 of %2 stations: those of points there are 0"),
         {std::to_string(unintense_), stations},
         FilePlace{file}});
  return result;
}

} // namespace espalier
