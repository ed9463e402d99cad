#include "core/reconstruct/trace.h"

#include "core/contract/geodesic_centroid.h"
#include "core/graph/components.h"
#include "core/graph/find_root.h"
#include "core/graph/geodesic.h"
#include "core/reconstruct/centered_line.h"
#include "core/reconstruct/leave_wood.h"

#include <queue>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

namespace espalier {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();
constexpr float widestLink = 4; // in spacings: one of this length costs twice its length
constexpr int neighbors = 12;   // as the default reconstruction links them

struct Reached {
  float cost;
  std::uint32_t point;
  [[nodiscard]] bool operator>(const Reached& other) const {
    return cost != other.cost ? cost > other.cost : point > other.point;
  }
};
using Queue = std::priority_queue<Reached, std::vector<Reached>, std::greater<>>;

std::shared_ptr<const Eigen::Matrix3Xf> contract(const PointCloud& cloud, double spacing,
                                                 const Progress& progress) {
  if (spacing == 0) return std::make_shared<const Eigen::Matrix3Xf>(cloud.positions());
  constexpr double radius = 7.5; // in point spacings, as the default reconstruction contracts
  return std::make_shared<const Eigen::Matrix3Xf>(contractedToGeodesicCentroids(
      cloud.positions(), {.neighbors = 7, .radius = radius * spacing}, progress));
}

/// Is a fifth of the path, and more than one place of it, away from all of the others?
bool isOtherPath(const Trace& trace, const std::vector<Trace>& others, double apart) {
  std::size_t away = 0;
  for (const Eigen::Vector3d& place : trace.places)
    if (std::ranges::all_of(others, [&](const Trace& other) {
          return distanceToLine(place, other.places) > apart;
        }))
      ++away;
  return away > 1 && 5 * away >= trace.places.size();
}

/// Places of a stroke without those that were picked on other wood, before it or far behind it: of
/// all choices from the first to the last, the one that leaves out fewest and jumps least. Time
/// O(n) for n places.
std::vector<Eigen::Vector3d> withoutAside(const std::vector<Eigen::Vector3d>& places,
                                          double spacing) {
  constexpr std::size_t mostLeftOut = 30; // in a row
  constexpr double ofUsual = 3;           // so many usual steps are no jump
  constexpr double ofLeftOut = 1;         // cost of each, and of a jump by so many spacings:
  constexpr double ofJump = 4;
  if (places.size() < 3 || spacing == 0) return places;
  std::vector<double> steps;
  for (std::size_t i = 1; i < places.size(); ++i)
    steps.push_back((places[i] - places[i - 1]).norm());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const double usual = std::max(*middle, spacing);
  std::vector<double> costs(places.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(places.size(), 0);
  costs[0] = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    for (std::size_t k = i - std::min(i, mostLeftOut + 1); k < i; ++k) {
      const auto many = static_cast<double>(i - k);
      const double jump = (places[i] - places[k]).norm() - ofUsual * usual * many;
      const double cost =
          costs[k] + ofLeftOut * (many - 1) + std::max(0.0, jump) / (ofJump * spacing);
      if (cost >= costs[i]) continue;
      costs[i] = cost;
      before[i] = k;
    }
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = places.size() - 1; i > 0; i = before[i]) // where it ends is meant
    kept.push_back(places[i]);
  kept.push_back(places[0]);
  std::ranges::reverse(kept);
  return kept;
}

bool isIn(const EdgeIndex& wood, const Eigen::Vector3d& place) {
  return wood.distanceToSurface(place, [](NodeId) { return true; }) == 0;
}

/// Leads a line on as far as the point it ends at: contraction draws the ends of wood in.
void leadOnTo(const Eigen::Vector3d& point, std::vector<Eigen::Vector3d>& line) {
  constexpr std::size_t back = 4; // places, a step together
  const Eigen::Vector3d& from = line[line.size() > back ? line.size() - 1 - back : 0];
  const Eigen::Vector3d along = (line.back() - from).normalized();
  const double ahead = (point - line.back()).dot(along);
  if (ahead > 0) line.emplace_back(line.back() + ahead * along);
}

} // namespace

/// Points from the start to the end.
struct TraceGraph::PointPath {
  std::vector<std::uint32_t> points;
};

double Trace::length() const {
  return lengthOfLine(places);
}

TraceGraph::TraceGraph(std::shared_ptr<const PointCloud> cloud,
                       std::shared_ptr<const Eigen::Matrix3Xf> contracted, const Progress& progress)
    : cloud_(std::move(cloud)), spacing_(pointSpacing(cloud_->positions())),
      contracted_(contracted ? std::move(contracted)
                             : contract(*cloud_, spacing_, progress.part(0, 0.6))),
      graph_(joined(NeighborhoodGraph(cloud_->positions(), neighbors, progress.part(0.6, 0.9)),
                    cloud_->positions(), std::numeric_limits<float>::max(), progress.part(0.9, 1))),
      scanned_(cloud_->positions()), inWood_(*contracted_) {
  assert(!cloud_->isEmpty());
  assert(contracted_->cols() == cloud_->size());
  progress.update(1);
}

std::vector<Trace> TraceGraph::between(const TraceEnd& from, const TraceEnd& to,
                                       const TraceOptions& options,
                                       const Progress& progress) const {
  assert(options.step > 0);
  const std::uint32_t first = pointAt(from);
  const std::uint32_t last = pointAt(to);
  const auto reach = static_cast<float>(std::max(3 * options.step, 8 * spacing_));
  std::vector<bool> isExpensive(static_cast<std::size_t>(cloud_->size()), false);
  std::vector<Trace> traces;
  for (int tried = 0; tried <= options.alternatives; ++tried) {
    PointPath path = pointPath(first, last, isExpensive, progress);
    if (from.isFixed && widestLeap(path.points) > widestLink * spacing_) // from the start as well
      path = pointPath(first, last, isExpensive, progress, from.place);
    Trace trace = traceFromWood(path.points, from, to, options);
    const bool isFirst = traces.empty();
    if (!isFirst && trace.length() > 3 * traces.front().length()) break;
    if (isFirst || isOtherPath(trace, traces, std::max(options.step, 4 * spacing_)))
      traces.push_back(std::move(trace));
    for (const std::uint32_t point : woodAlong(path.points, reach / 2))
      isExpensive[point] = true;
  }
  return traces;
}

Trace TraceGraph::through(const std::vector<Eigen::Vector3d>& places, bool startIsFixed,
                          const TraceOptions& options, const Progress& progress) const {
  assert(places.size() > 1 && options.step > 0);
  std::vector<std::uint32_t> points;
  const double apart = std::max(options.step / 2, spacing_);
  for (const Eigen::Vector3d& place : spacedEvenly(withoutAside(places, spacing_), apart)) {
    progress.check();
    points.push_back(static_cast<std::uint32_t>(nearestPoint(cloud_->positions(), local(place))));
  }
  return traceFromWood(points, {places.front(), startIsFixed}, {places.back(), false}, options);
}

Eigen::Vector3d TraceGraph::farthestFrom(const Eigen::Vector3d& place) const {
  const std::vector<float> distances =
      geodesics(graph_, {static_cast<Eigen::Index>(pointAt({place, false}))}).distance;
  return cloud_->position(std::ranges::max_element(distances) - distances.begin());
}

std::optional<Eigen::Vector3d> TraceGraph::farthestFrom(const EdgeIndex& wood, double about,
                                                        double least) const {
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < cloud_->size(); ++i)
    if (wood.distanceToSurface(cloud_->position(i), [](NodeId) { return true; }) <= about)
      near.push_back(i);
  if (near.empty()) return std::nullopt;
  const std::vector<float> distances = geodesics(graph_, near).distance;
  const auto farthest = std::ranges::max_element(distances);
  if (static_cast<double>(*farthest) < least) return std::nullopt;
  return cloud_->position(farthest - distances.begin());
}

Eigen::Vector3f TraceGraph::local(const Eigen::Vector3d& place) const {
  return (place - cloud_->origin()).cast<float>();
}

std::uint32_t TraceGraph::pointAt(const TraceEnd& end) const {
  // A node lies inside the wood, where points contract to; a picked place lies on the bark.
  const Eigen::Matrix3Xf& points = end.isFixed ? *contracted_ : cloud_->positions();
  return static_cast<std::uint32_t>(nearestPoint(points, local(end.place)));
}

TraceGraph::PointPath TraceGraph::pointPath(std::uint32_t from, std::uint32_t to,
                                            const std::vector<bool>& isExpensive,
                                            const Progress& progress,
                                            const std::optional<Eigen::Vector3d>& leap) const {
  constexpr float bark = 0.1F; // share of the path over the bark that counts
  constexpr float expense = 6;
  const Eigen::Matrix3Xf& places = *contracted_;
  const auto spacing = static_cast<float>(spacing_ > 0 ? spacing_ : 1);
  const auto count = static_cast<std::size_t>(cloud_->size());
  std::vector<float> costs(count, infinite);
  std::vector<std::uint32_t> before(count, noPoint);
  const auto costOf = [&](std::uint32_t point, const NeighborhoodGraph::Link& link) {
    const float far = link.length / (widestLink * spacing);
    const float cost =
        ((places.col(point) - places.col(link.to)).norm() + bark * link.length) * (1 + far * far);
    return isExpensive[point] && isExpensive[link.to] ? expense * cost : cost;
  };
  // No path is shorter than the straight one: the search goes towards the end (A*).
  const auto left = [&](std::uint32_t point) {
    return (places.col(point) - places.col(to)).norm();
  };
  Queue queue;
  costs[from] = 0;
  queue.push({left(from), from});
  if (leap) { // somebody said that it leads on from there: half of what others cost
    const Eigen::Vector3f place = local(*leap);
    for (std::uint32_t point = 0; point < count; ++point) {
      const float length = (cloud_->positions().col(point) - place).norm();
      const float far = length / (widestLink * spacing);
      if (point == from) continue;
      costs[point] = length * (1 + far * far) / 2;
      before[point] = from;
      queue.push({costs[point] + left(point), point});
    }
  }
  std::vector<bool> isSettled(count, false);
  for (std::size_t settled = 0; !queue.empty() && !isSettled[to];) {
    const std::uint32_t point = queue.top().point;
    queue.pop();
    if (isSettled[point]) continue;
    isSettled[point] = true;
    if (++settled % 8192 == 0) progress.check();
    for (const NeighborhoodGraph::Link& link : graph_.links(point)) {
      const float cost = costs[point] + costOf(point, link);
      if (cost >= costs[link.to] || isSettled[link.to]) continue;
      costs[link.to] = cost;
      before[link.to] = point;
      queue.push({cost + left(link.to), link.to});
    }
  }
  PointPath path;
  for (std::uint32_t point = to; point != noPoint; point = before[point])
    path.points.push_back(point);
  std::ranges::reverse(path.points);
  return path;
}

double TraceGraph::widestLeap(const std::vector<std::uint32_t>& points) const {
  double widest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    widest =
        std::max(widest, (cloud_->position(points[i]) - cloud_->position(points[i - 1])).norm());
  return widest;
}

std::vector<std::uint32_t> TraceGraph::woodAlong(const std::vector<std::uint32_t>& points,
                                                 float reach) const {
  std::vector<float> distances(static_cast<std::size_t>(graph_.size()), infinite);
  std::vector<std::uint32_t> wood;
  Queue queue;
  for (const std::uint32_t point : points) {
    distances[point] = 0;
    queue.push({0, point});
  }
  std::vector<bool> isSettled(distances.size(), false);
  while (!queue.empty()) {
    const Reached near = queue.top();
    queue.pop();
    if (isSettled[near.point]) continue;
    isSettled[near.point] = true;
    wood.push_back(near.point);
    for (const NeighborhoodGraph::Link& link : graph_.links(near.point)) {
      const float distance = near.cost + link.length;
      if (distance > reach || distance >= distances[link.to]) continue;
      distances[link.to] = distance;
      queue.push({distance, link.to});
    }
  }
  std::ranges::sort(wood); // the order of the points, not that of the search
  return wood;
}

std::vector<Eigen::Vector3d> TraceGraph::slabAround(std::uint32_t seed,
                                                    const Eigen::Vector3d& place,
                                                    const Eigen::Vector3d& axis,
                                                    double step) const {
  const double widest = std::max(3 * step, 8 * spacing_); // off the place
  std::vector<std::uint32_t> met = {seed};
  std::unordered_set<std::uint32_t> isMet = {seed};
  std::vector<Eigen::Vector3d> slab;
  for (std::size_t next = 0; next < met.size(); ++next) {
    const Eigen::Vector3d point = cloud_->position(met[next]);
    slab.push_back(point);
    for (const NeighborhoodGraph::Link& link : graph_.links(met[next])) {
      if (link.length > widestLink * static_cast<float>(spacing_)) continue;
      const Eigen::Vector3d off = cloud_->position(link.to) - place;
      if (std::abs(off.dot(axis)) > step / 2 || off.norm() > widest) continue;
      if (isMet.insert(link.to).second) met.push_back(link.to);
    }
  }
  return slab;
}

Trace TraceGraph::traceFromWood(std::vector<std::uint32_t> points, const TraceEnd& from,
                                const TraceEnd& to, const TraceOptions& options) const {
  if (!options.wood || options.wood->edges().empty() || spacing_ == 0 || !from.isFixed)
    return traceOf(points, from, to, options.step);
  std::vector<Eigen::Vector3d> places = {from.place};
  for (const std::uint32_t point : points)
    places.push_back(cloud_->position(point));
  const NearestPlace start = *options.wood->nearest(from.place);
  const std::optional<Leaving> leaving = leavingWood(places, *options.wood, spacing_);
  if (!leaving) {
    Trace trace = traceOf(points, from, to, options.step);
    if (!options.keepsStart) trace.begin = {start.node, start.share};
    return trace;
  }
  // Beside thick wood, points contract into that.
  std::size_t first = leaving->first - 1;
  const auto isDrawnIn = [&](std::uint32_t point) {
    const Eigen::Vector3d place = contracted_->col(point).cast<double>() + cloud_->origin();
    return options.wood->distanceToSurface(place, [](NodeId) { return true; }) <= spacing_;
  };
  while (first + 2 < points.size() && isDrawnIn(points[first]))
    ++first;
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  const Eigen::Vector3d foot = options.keepsStart ? from.place : leaving->place;
  Trace trace = traceOf(points, {foot, true}, to, options.step, options.wood.get());
  std::size_t inside = 1; // the edge from the middle of the wood needs no place in that
  while (inside + 1 < trace.places.size() && isIn(*options.wood, trace.places[inside]))
    ++inside;
  trace.places.erase(trace.places.begin() + 1, trace.places.begin() + std::ptrdiff_t(inside));
  trace.radii.erase(trace.radii.begin() + 1, trace.radii.begin() + std::ptrdiff_t(inside));
  if (!options.keepsStart) trace.begin = leaving->begin;
  return trace;
}

Trace TraceGraph::traceOf(const std::vector<std::uint32_t>& points, const TraceEnd& from,
                          const TraceEnd& to, double step, const EdgeIndex* wood) const {
  std::vector<Eigen::Vector3d> line;
  line.reserve(points.size());
  for (const std::uint32_t point : points)
    line.emplace_back(contracted_->col(point).cast<double>() + cloud_->origin());
  const auto seedAt = [&, contracted = line](const Eigen::Vector3d& place) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < contracted.size(); ++i)
      if ((contracted[i] - place).squaredNorm() < (contracted[nearest] - place).squaredNorm())
        nearest = i;
    return points[nearest];
  };
  if (line.size() == 1) line.push_back(line.front());
  if (from.isFixed) line.front() = from.place;
  if (to.isFixed) line.back() = to.place;
  constexpr int smoothings = 5; // of places 1.5 spacings apart: no zigzag from point to point
  const double fine = spacing_ > 0 ? 1.5 * spacing_ : step / 4;
  line = smoothedLine(spacedEvenly(line, fine), 0.5, smoothings);
  if (!to.isFixed) leadOnTo(cloud_->position(points.back()), line);
  if (!from.isFixed) {
    std::ranges::reverse(line);
    leadOnTo(cloud_->position(points.front()), line);
    std::ranges::reverse(line);
  }
  line = spacedEvenly(line, 2 * fine);
  const double slab = std::clamp(step, 3 * fine, 6 * fine); // how thick wood is cut
  std::vector<double> radii(line.size(), 0);
  for (int round = 0; round < 2; ++round) { // the second cuts across the better axis
    const std::vector<Eigen::Vector3d> before = line;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto axis = directionAt(before, i);
      if (!axis) continue;
      const auto section =
          sectionAt(before[i], *axis, slabAround(seedAt(before[i]), before[i], *axis, slab));
      if (!section || (wood != nullptr && isIn(*wood, section->middle))) continue;
      radii[i] = section->radius;
      const bool isFixed = (i == 0 && from.isFixed) || (i + 1 == line.size() && to.isFixed);
      if (!isFixed) line[i] = section->middle;
    }
    line = smoothedLine(line, 0.5, 2);
  }
  return onThePoints(spaced({line, radii}, step), from, to);
}

} // namespace espalier
