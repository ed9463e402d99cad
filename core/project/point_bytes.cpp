#include "core/project/point_bytes.h"

#include "core/base/shown_message.h"

#include <bit>
#include <cstring>
#include <span>
#include <utility>

namespace espalier {
namespace {

static_assert(std::endian::native == std::endian::little, "parts are copied as they are");

template <class T> void append(std::string& bytes, std::span<const T> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

template <class T> void take(std::string_view& bytes, std::span<T> values) {
  if (bytes.size() < values.size_bytes())
    throw ShownError({espalier::Shown::tr("stored points end too early: open the scan again")});
  if (values.empty()) return;
  std::memcpy(values.data(), bytes.data(), values.size_bytes());
  bytes.remove_prefix(values.size_bytes());
}

/// A vector of `count` values, which the bytes must hold.
template <class T> std::vector<T> taken(std::string_view& bytes, std::uint64_t count) {
  if (count > bytes.size() / sizeof(T))
    throw ShownError({espalier::Shown::tr("stored points end too early: open the scan again")});
  std::vector<T> values(count);
  take(bytes, std::span<T>(values));
  return values;
}

/// Their names and where scanners stood, then the station of each point.
void appendStations(std::string& bytes, const PointCloud& cloud) {
  const std::uint64_t sizes[] = {cloud.stations().size(), cloud.stationOf().size()};
  append(bytes, std::span<const std::uint64_t>(sizes));
  for (const Station& station : cloud.stations()) {
    const std::uint64_t head[] = {station.name.size(), station.scanner.has_value() ? 1U : 0U};
    append(bytes, std::span<const std::uint64_t>(head));
    bytes += station.name;
    if (station.scanner) append(bytes, std::span<const double>(station.scanner->data(), 3));
  }
  append(bytes, std::span<const StationIndex>(cloud.stationOf()));
}

void takeStations(std::string_view& bytes, StoredPoints& stored) {
  const std::vector<std::uint64_t> sizes = taken<std::uint64_t>(bytes, 2);
  if (sizes[0] > mostStations)
    throw ShownError(
        {espalier::Shown::tr("stored points have too many stations: open the scan again")});
  for (std::uint64_t i = 0; i < sizes[0]; ++i) {
    const std::vector<std::uint64_t> head = taken<std::uint64_t>(bytes, 2);
    const std::vector<char> name = taken<char>(bytes, head[0]);
    Station station{.name = {name.begin(), name.end()}, .scanner = {}};
    if (head[1] != 0) {
      station.scanner.emplace();
      take(bytes, std::span<double>(station.scanner->data(), 3));
    }
    stored.stations.push_back(std::move(station));
  }
  stored.stationOf = taken<StationIndex>(bytes, sizes[1]);
}

std::span<const float> coordinatesOf(const Eigen::Matrix3Xf& positions) {
  return {positions.data(), static_cast<std::size_t>(positions.size())};
}

Eigen::Matrix3Xf takenPositions(std::string_view& bytes, std::uint64_t count) {
  constexpr std::size_t each = 3 * sizeof(float);
  if (count > bytes.size() / each)
    throw ShownError({espalier::Shown::tr("stored points end too early: open the scan again")});
  Eigen::Matrix3Xf positions(3, static_cast<Eigen::Index>(count));
  take(bytes, std::span<float>(positions.data(), static_cast<std::size_t>(positions.size())));
  return positions;
}

void requireEnd(std::string_view bytes) {
  if (!bytes.empty())
    throw ShownError(
        {espalier::Shown::tr("stored points are followed by more: open the scan again")});
}

} // namespace

std::string bytesOf(const PointCloud& cloud) {
  const std::uint64_t sizes[] = {static_cast<std::uint64_t>(cloud.size()), cloud.colors().size(),
                                 cloud.intensities().size()};
  std::string bytes;
  append(bytes, std::span<const std::uint64_t>(sizes));
  append(bytes, std::span<const double>(cloud.origin().data(), 3));
  append(bytes, coordinatesOf(cloud.positions()));
  append(bytes, std::span<const std::uint32_t>(cloud.fileOrder()));
  append(bytes, std::span<const Color>(cloud.colors()));
  append(bytes, std::span<const float>(cloud.intensities()));
  if (!cloud.stations().empty()) appendStations(bytes, cloud);
  return bytes;
}

PointCloud cloudFrom(std::string_view bytes) {
  const std::vector<std::uint64_t> sizes = taken<std::uint64_t>(bytes, 3);
  StoredPoints stored;
  take(bytes, std::span<double>(stored.origin.data(), 3));
  stored.positions = takenPositions(bytes, sizes[0]);
  stored.fileOrder = taken<std::uint32_t>(bytes, sizes[0]);
  stored.colors = taken<Color>(bytes, sizes[1]);
  stored.intensities = taken<float>(bytes, sizes[2]);
  if (!bytes.empty()) takeStations(bytes, stored); // clouds of before have none
  requireEnd(bytes);
  return PointCloud(std::move(stored));
}

std::string bytesOf(const Eigen::Matrix3Xf& positions) {
  std::string bytes;
  append(bytes, coordinatesOf(positions));
  return bytes;
}

Eigen::Matrix3Xf positionsFrom(std::string_view bytes) {
  Eigen::Matrix3Xf positions = takenPositions(bytes, bytes.size() / (3 * sizeof(float)));
  requireEnd(bytes);
  if (!positions.allFinite())
    throw ShownError({espalier::Shown::tr("stored points are not all finite: make them again")});
  return positions;
}

} // namespace espalier
