#pragma once

#include "core/base/parallel.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>
#include <oneapi/tbb/enumerable_thread_specific.h>

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace espalier {

/// Finds the points within a distance along the graph of several near centers at once, again and
/// again, without new memory. One per thread.
///
/// The balls of near centers hold much the same points. They are searched together: each link is
/// followed for all centers in one go, which a processor does with a few instructions. A point is
/// looked at again when a shorter path to it is found, which spares the queue by distance of
/// Dijkstra; the distances are the same to the last bit.
class GeodesicBalls {
public:
  static constexpr Eigen::Index most = 16; // centers at once
  using Lanes = Eigen::Array<float, most, 1>;

  explicit GeodesicBalls(const NeighborhoodGraph& graph)
      : graph_(graph), placeOf_(static_cast<std::size_t>(graph.size()), none) {}

  /// Searches along the links of the graph by their length. Valid until the next call.
  ///
  /// @param centers at most `most` points; near ones share most of the work
  /// @param radii   one per center [L], >= 0
  /// Time O(m) for m links met by any of the balls, each about three times.
  void find(std::span<const std::uint32_t> centers, const Lanes& radii) {
    find(centers, radii,
         [](std::uint32_t, const NeighborhoodGraph::Link& link) { return link.length; });
  }

  /// The same with other lengths: length(from, link) is a float, or Lanes if it is another one for
  /// each center; >= 0.
  template <class Length>
  void find(std::span<const std::uint32_t> centers, const Lanes& radii, const Length& length);

  [[nodiscard]] std::span<const std::uint32_t> centers() const { return centers_; }

  /// Calls visit(center, point, distance) for each point of each ball, the centers among them;
  /// `center` is its place in centers().
  template <class Visit> void forEachMember(const Visit& visit) const {
    for (std::size_t place = 0; place < met_.size(); ++place)
      for (std::size_t lane = 0; lane < centers_.size(); ++lane) {
        const float distance = distances_[place][static_cast<Eigen::Index>(lane)];
        if (distance < limits_[static_cast<Eigen::Index>(lane)]) visit(lane, met_[place], distance);
      }
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// The place of `point` among those met; a new one has distances beyond all radii.
  std::uint32_t meet(std::uint32_t point) {
    std::uint32_t& place = placeOf_[point];
    if (place != none) return place;
    place = static_cast<std::uint32_t>(met_.size());
    met_.push_back(point);
    distances_.push_back(limits_);
    isQueued_.push_back(0);
    return place;
  }
  void queue(std::uint32_t place) {
    if (isQueued_[place]) return;
    isQueued_[place] = 1;
    queue_.push_back(place);
  }

  const NeighborhoodGraph& graph_;
  std::vector<std::uint32_t> placeOf_; // by point; none between calls
  std::vector<std::uint32_t> centers_;
  Lanes limits_; // the least floats above the radii; 0 where there is no center
  std::vector<std::uint32_t> met_;
  std::vector<Lanes> distances_; // by place
  std::vector<char> isQueued_;   // by place
  std::vector<std::uint32_t> queue_;
};

template <class Length>
void GeodesicBalls::find(std::span<const std::uint32_t> centers, const Lanes& radii,
                         const Length& length) {
  for (const std::uint32_t point : met_)
    placeOf_[point] = none;
  met_.clear();
  distances_.clear();
  isQueued_.clear();
  queue_.clear();
  centers_.assign(centers.begin(), centers.end());
  limits_.setZero();
  for (std::size_t lane = 0; lane < centers_.size(); ++lane) {
    const auto i = static_cast<Eigen::Index>(lane);
    limits_[i] = std::nextafter(radii[i], std::numeric_limits<float>::infinity());
  }
  for (std::size_t lane = 0; lane < centers_.size(); ++lane) {
    const std::uint32_t place = meet(centers_[lane]);
    distances_[place][static_cast<Eigen::Index>(lane)] = 0;
    queue(place);
  }
  std::size_t end = queue_.size();
  for (std::size_t next = 0; next < end; ++next) {
    const std::uint32_t near = queue_[next];
    isQueued_[near] = 0;
    const std::uint32_t from = met_[near];
    const Lanes soFar = distances_[near];
    const std::span<const NeighborhoodGraph::Link> links = graph_.links(from);
    if (queue_.size() < end + links.size()) queue_.resize(2 * (end + links.size()));
    for (const NeighborhoodGraph::Link& link : links) {
      const Lanes distance = soFar + length(from, link);
      if (placeOf_[link.to] == none && !((limits_ - distance).maxCoeff() > 0)) continue;
      const std::uint32_t place = meet(link.to);
      Lanes& known = distances_[place];
      const Lanes before = known;
      known = before.min(distance);
      // No branch: half of the links bring something nearer, in no order that could be foreseen.
      const bool isNearer = (before - distance).maxCoeff() > 0;
      queue_[end] = place;
      end += static_cast<std::size_t>(isNearer && isQueued_[place] == 0 ? 1 : 0);
      isQueued_[place] |= static_cast<char>(isNearer ? 1 : 0);
    }
  }
}

/// Centers in groups of near ones, each to be searched together.
struct BallGroups {
  std::vector<std::uint32_t> points; // each once
  std::vector<std::size_t> ends;     // of the groups, in `points`

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t group) const {
    return {points.data() + (group == 0 ? 0 : ends[group - 1]), points.data() + ends[group]};
  }
};

/// Groups all points of the graph with those around them. Deterministic. Time O(N + links).
[[nodiscard]] BallGroups ballGroups(const NeighborhoodGraph& graph);

/// Searches the balls of all points on all threads. Groups are the same for any number of them.
///
/// @param radiusOf radiusOf(point): of its ball [L]
/// @param find     find(balls, centers, radii): calls one of the finds of `balls`
/// @param visit    visit(balls): reads them, and writes only what belongs to their centers
/// @throws Cancelled if `progress` asks to stop
template <class RadiusOf, class Find, class Visit>
void forEachGeodesicBalls(const NeighborhoodGraph& graph, const RadiusOf& radiusOf,
                          const Find& find, const Visit& visit, const Progress& progress) {
  const BallGroups groups = ballGroups(graph);
  oneapi::tbb::enumerable_thread_specific<GeodesicBalls> all([&] { return GeodesicBalls(graph); });
  const auto searchGroup = [&](Eigen::Index group) {
    const std::span<const std::uint32_t> centers = groups.of(static_cast<std::size_t>(group));
    GeodesicBalls::Lanes radii = GeodesicBalls::Lanes::Zero();
    for (std::size_t lane = 0; lane < centers.size(); ++lane)
      radii[static_cast<Eigen::Index>(lane)] = static_cast<float>(radiusOf(centers[lane]));
    GeodesicBalls& balls = all.local();
    find(balls, centers, radii);
    visit(balls);
  };
  parallelFor(static_cast<Eigen::Index>(groups.size()), searchGroup, progress, 2);
}

/// The same, along the links by their length.
template <class RadiusOf, class Visit>
void forEachGeodesicBalls(const NeighborhoodGraph& graph, const RadiusOf& radiusOf,
                          const Visit& visit, const Progress& progress) {
  forEachGeodesicBalls(
      graph, radiusOf,
      [](GeodesicBalls& balls, std::span<const std::uint32_t> centers,
         const GeodesicBalls::Lanes& radii) { balls.find(centers, radii); },
      visit, progress);
}

} // namespace espalier
