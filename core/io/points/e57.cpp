#include "core/io/points/e57.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/cloud/spherical.h"
#include "core/io/points/e57_packets.h"
#include "core/io/points/e57_pages.h"
#include "core/io/points/e57_scans.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/station_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

/// The values of a record by role; those of roles that it lacks are 0.
using E57Values = std::array<double, indexOf(E57Role::count)>;

bool hasRole(const E57Scan& scan, E57Role role) {
  return std::ranges::find(scan.fields, role, &E57Field::role) != scan.fields.end();
}

std::vector<PointField> pointFieldsOf(const E57Scan& scan) {
  std::vector<PointField> fields;
  for (const auto& [role, field] :
       {std::pair{E57Role::intensity, PointField::intensity},
        std::pair{E57Role::red, PointField::red}, std::pair{E57Role::green, PointField::green},
        std::pair{E57Role::blue, PointField::blue}})
    if (hasRole(scan, role)) fields.push_back(field);
  return fields;
}

/// Where limits are known, from 0 to 255 for bytes. Of 16 bits, 256 v and 257 v both stand for v.
double colorOf(double value, const E57Scan& scan, std::size_t channel) {
  if (!scan.colorLimits) return value;
  const E57Limits& limits = (*scan.colorLimits)[channel];
  const double range = limits.most - limits.least;
  const double byte = range < 255 ? std::round(255 * (value - limits.least) / range)
                                  : std::floor(256 * (value - limits.least) / (range + 1));
  return std::clamp(byte, 0.0, 255.0);
}

PointValues pointOf(const E57Values& values, const E57Scan& scan, bool isSpherical) {
  const auto value = [&](E57Role role) { return values[indexOf(role)]; };
  const Eigen::Vector3d measured =
      isSpherical
          ? fromSpherical(value(E57Role::range), value(E57Role::azimuth), value(E57Role::elevation))
          : Eigen::Vector3d(value(E57Role::x), value(E57Role::y), value(E57Role::z));
  const Eigen::Vector3d position = scan.pose * measured;
  PointValues point{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[indexOf(PointField::x) + axis] = position[static_cast<Eigen::Index>(axis)];
  if (value(E57Role::invalidIntensity) == 0)
    point[indexOf(PointField::intensity)] = value(E57Role::intensity);
  if (value(E57Role::invalidColor) == 0)
    for (std::size_t channel = 0; channel < 3; ++channel)
      point[indexOf(PointField::red) + channel] =
          colorOf(values[indexOf(E57Role::red) + channel], scan, channel);
  return point;
}

/// Its scanner stood where its own frame begins. Positions x y z without a pose may be in any
/// frame.
Station stationOf(const E57Scan& scan) {
  Station station{.name = scan.name, .scanner = {}};
  if (scan.hasPose || hasRole(scan, E57Role::range)) station.scanner = scan.pose.translation();
  return station;
}

/// Adds the points of a scan whose position was measured.
/// @return how many there are, whether they are kept or not
std::uint64_t addPoints(const E57Scan& scan, E57Packets& packets, PartChooser& chooser,
                        StationPoints& stations, const Progress& progress) {
  const bool isSpherical = hasRole(scan, E57Role::range);
  std::vector<E57Stream> streams = packets.begin(scan);
  PointCollector points(pointFieldsOf(scan), scan.records, chooser);
  std::vector<std::pair<std::size_t, E57Stream*>> used; // by the place of their value
  for (std::size_t i = 0; i < streams.size(); ++i)
    if (scan.fields[i].role != E57Role::none)
      used.emplace_back(indexOf(scan.fields[i].role), &streams[i]);
  E57Values values{};
  std::uint64_t measured = 0;
  std::uint64_t ready = 0;
  for (std::uint64_t record = 0; record < scan.records; ++record) {
    if (record % 65536 == 0)
      progress.update(static_cast<double>(record) / static_cast<double>(scan.records));
    if (ready == 0) ready = packets.readOn(streams, progress);
    --ready;
    for (const auto& [place, stream] : used)
      values[place] = stream->next();
    if (values[indexOf(E57Role::invalidPosition)] == 0) {
      points.add(pointOf(values, scan, isSpherical));
      ++measured;
    } else {
      chooser.pass();
    }
  }
  points.reduce();
  const std::vector<std::uint64_t> ranks = points.ranks();
  stations.add(std::move(points).finish(!scan.colorLimits), ranks, stationOf(scan));
  return measured;
}

/// Checks the promised numbers of points before memory is taken for them: points of no bits, as
/// where all values of a field are the same, would fill any memory.
/// @return how many there are in all
std::uint64_t checkedRecords(const std::vector<E57Scan>& scans, const E57Pages& pages) {
  constexpr std::uint64_t freePoints = 1 << 20;
  constexpr std::uint64_t mostPoints = 4; // to a byte
  std::uint64_t all = 0;
  for (const E57Scan& scan : scans) {
    std::uint64_t bits = 0;
    for (const E57Field& field : scan.fields)
      bits += field.bits;
    if (bits >= 8) checkPromise(FilePlace{pages.file()}, scan.records, bits / 8, pages.size());
    const std::uint64_t most = freePoints + mostPoints * pages.size();
    if (scan.records > most || all + scan.records > most)
      throw ShownError(
          {espalier::Shown::tr("promises %1 points of hardly any bits, as of no scan: the file "
                               "is damaged, export it again"),
           {std::to_string(scan.records)},
           FilePlace{pages.file()}});
    all += scan.records;
  }
  checkPromise(FilePlace{pages.file()}, all, 1, all);
  return all;
}

} // namespace

bool isE57(std::string_view beginning) {
  return beginning.starts_with("ASTM-E57");
}

ImportedPoints readE57(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  ByteSource source(in);
  const XmlFile xml(e57XmlOf(source, file), file + ", XML", "e57Root");
  const Imported<std::vector<E57Scan>> scans = e57ScansOf(xml);
  E57Pages pages(source, file);
  const std::uint64_t promised = checkedRecords(scans.value, pages);
  PartChooser chooser(options);
  E57Packets packets(pages);
  StationPoints stations(chooser);
  std::uint64_t read = 0;
  std::uint64_t measured = 0;
  for (const E57Scan& scan : scans.value) {
    const auto done = [&](std::uint64_t count) {
      return static_cast<double>(count) / static_cast<double>(promised);
    };
    measured += addPoints(scan, packets, chooser, stations,
                          progress.part(done(read), done(read + scan.records)));
    read += scan.records;
  }
  ImportedPoints result{std::move(stations).finish(file), read};
  if (measured < read)
    result.notes.push_back(
        {Shown::tr("%1 of %2 points are marked as having no position and are left out"),
         {std::to_string(read - measured), std::to_string(read)},
         FilePlace{file}});
  result.notes.insert(result.notes.end(), scans.notes.begin(), scans.notes.end());
  return result;
}

} // namespace espalier
