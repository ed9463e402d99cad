#include "core/io/points/part_chooser.h"

#include "core/base/coordinates.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr unsigned levelBits = 6; // of a rank, the highest; octrees of files have under 32 levels
constexpr unsigned lotBits = 64 - levelBits;
constexpr std::uint64_t lotMask = (std::uint64_t{1} << lotBits) - 1;

/// The lot of a place. Each act can be undone, so that no two places below 2^58 draw the same.
/// Source: the mixing of D. Stafford, "Better Bit Mixing", 2011, on 58 bits.
std::uint64_t lotOf(std::uint64_t place) {
  place = (place + 0x1e3779b97f4a7c15U) & lotMask;
  place = ((place ^ (place >> 30)) * 0xbf58476d1ce4e5b9U) & lotMask;
  place = ((place ^ (place >> 27)) * 0x94d049bb133111ebU) & lotMask;
  return place ^ (place >> 31);
}

} // namespace

PartChooser::PartChooser(const ReadOptions& options) : most_(options.most), box_(options.box) {
  constexpr std::uint64_t little = 1024;
  if (isLimited() && most_ < crowd_ / 2)
    crowd_ = static_cast<std::size_t>(most_ + most_ / 2 + little);
}

void PartChooser::goTo(std::uint64_t place, unsigned level) {
  place_ = place;
  level_ = level;
}

std::optional<std::uint64_t> PartChooser::offer(const Eigen::Vector3d& position) {
  const std::uint64_t place = place_++;
  if (!isPart()) return 0;
  if (box_ ? !box_->contains(position) : !isInRange(position)) return std::nullopt;
  if (!isLimited()) return 0;
  const std::uint64_t rank = level_ << lotBits | lotOf(place);
  if (!stays(rank)) return std::nullopt;
  return rank;
}

std::size_t PartChooser::roomFor(std::uint64_t count) const {
  constexpr std::uint64_t unknown = std::uint64_t{1} << 20; // how many lie in a box
  if (box_) count = std::min(count, unknown);
  return static_cast<std::size_t>(std::min<std::uint64_t>(count, crowd_));
}

void PartChooser::learn(const std::vector<std::uint64_t>& ranks) {
  if (!isLimited() || ranks.size() <= most_) return;
  std::vector<std::uint64_t> sorted = ranks;
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(most_) - 1;
  std::ranges::nth_element(sorted, last);
  limit_ = std::min(limit_, *last);
}

void keepThoseThatStay(RawPoints& points, std::vector<std::uint64_t>& ranks,
                       const PartChooser& chooser) {
  keepThoseThatStay(points.positions, ranks, chooser);
  keepThoseThatStay(points.colors, ranks, chooser);
  keepThoseThatStay(points.intensities, ranks, chooser);
  keepThoseThatStay(points.stationOf, ranks, chooser);
  std::erase_if(ranks, [&](std::uint64_t rank) { return !chooser.stays(rank); });
}

void dropEmptyStations(RawPoints& points) {
  if (points.stationOf.empty()) return;
  std::vector<bool> isMet(points.stations.size());
  for (const StationIndex station : points.stationOf)
    isMet[station] = true;
  std::vector<StationIndex> places(points.stations.size());
  std::vector<Station> left;
  for (std::size_t i = 0; i < isMet.size(); ++i) {
    places[i] = static_cast<StationIndex>(left.size());
    if (isMet[i]) left.push_back(std::move(points.stations[i]));
  }
  points.stations = std::move(left);
  for (StationIndex& station : points.stationOf)
    station = places[station];
  if (points.stations.size() == 1) points.stationOf.clear();
}

RawPoints partOf(RawPoints points, const ReadOptions& options) {
  if (!options.isPart()) return points;
  PartChooser chooser(options);
  // Those left out get a rank that never stays.
  constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::uint64_t> ranks;
  std::vector<std::uint64_t> offered;
  for (const Eigen::Vector3d& position : points.positions) {
    ranks.push_back(chooser.offer(position).value_or(never));
    if (ranks.back() != never) offered.push_back(ranks.back());
  }
  chooser.learn(offered);
  keepThoseThatStay(points, ranks, chooser);
  dropEmptyStations(points);
  return points;
}

} // namespace espalier
