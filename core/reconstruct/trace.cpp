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

/// Radii with those between two that are known in place of 0.
std::vector<double> filled(std::vector<double> radii) {
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (radii[i] == 0) continue;
    for (std::size_t k = before.value_or(i); k < i; ++k) {
      const double share = static_cast<double>(k - *before) / static_cast<double>(i - *before);
      radii[k] = radii[*before] + share * (radii[i] - radii[*before]);
    }
    before = i;
  }
  return radii;
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

/// Places of a fine trace as they become nodes: evenly spaced, and more where the edges between
/// them would leave the middle of the wood.
Trace TraceGraph::spaced(const Trace& fine, double step) const {
  constexpr double shortest = 3; // spacings: shorter edges follow the noise of the points
  const std::vector<double> wood = filled(fine.radii);
  const double even = std::max(step, shortest * spacing_);
  const std::size_t last = fine.places.size() - 1;
  const double length = fine.length();
  const auto count = std::max(1.0, std::round(length / even));
  std::vector<std::size_t> kept = {0};
  double passed = 0;
  double wanted = length / count;
  for (std::size_t i = 1; i < last; ++i) {
    const double piece = (fine.places[i] - fine.places[i - 1]).norm();
    const double next = (fine.places[i + 1] - fine.places[i]).norm();
    passed += piece;
    if (std::abs(passed - wanted) > std::abs(passed + next - wanted) || passed + next / 2 < wanted)
      continue;
    if (length - passed < even / 2) break;
    kept.push_back(i);
    wanted += length / count;
  }
  kept.push_back(last);
  for (std::size_t at = 1; at < kept.size();) { // as R. Douglas and T. Peucker, 1973
    const std::array<Eigen::Vector3d, 2> edge = {fine.places[kept[at - 1]], fine.places[kept[at]]};
    std::size_t farthest = 0;
    double excess = 0;
    for (std::size_t i = kept[at - 1] + 1; i < kept[at]; ++i) {
      const double most = std::max(wood[i] / 4, 0.3 * spacing_);
      const double off = distanceToLine(fine.places[i], {edge[0], edge[1]}) - most;
      const bool isApart = (fine.places[i] - edge[0]).norm() >= shortest * spacing_ &&
                           (fine.places[i] - edge[1]).norm() >= shortest * spacing_;
      if (off <= excess || !isApart) continue;
      excess = off;
      farthest = i;
    }
    if (excess > 0)
      kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(at), farthest);
    else
      ++at;
  }
  for (std::size_t at = 1; kept.size() > 2 && at + 1 < kept.size();) { // wood does not fold back
    const Eigen::Vector3d below = fine.places[kept[at]] - fine.places[kept[at - 1]];
    const Eigen::Vector3d above = fine.places[kept[at + 1]] - fine.places[kept[at]];
    constexpr double least = -0.17; // cosine of 100 degrees
    if (below.dot(above) >= least * below.norm() * above.norm()) {
      ++at;
      continue;
    }
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(at));
    at = std::max<std::size_t>(1, at - 1);
  }
  Trace trace;
  for (const std::size_t i : kept) {
    trace.places.push_back(fine.places[i]);
    trace.radii.push_back(wood[i]);
  }
  return trace;
}

double TraceGraph::toPoints(const Eigen::Vector3d& place) const {
  return std::sqrt(static_cast<double>(scanned_.nearest(local(place), 1)[0].squaredDistance));
}

/// A place off the points goes back to them; none: there are none to go back to, it is in a gap.
/// Points may be far from the middle of thick wood: what they contract to is near then.
std::optional<Eigen::Vector3d> TraceGraph::onPoints(const Eigen::Vector3d& place,
                                                    double radius) const {
  const double gap = 4 * spacing_;
  const Neighbor scanned = scanned_.nearest(local(place), 1)[0];
  const double distance = std::sqrt(static_cast<double>(scanned.squaredDistance));
  if (distance <= radius + 1.5 * spacing_) return place;
  if (distance <= gap) {
    const Eigen::Vector3d point = cloud_->position(scanned.index);
    return point + 1.4 * spacing_ / distance * (place - point);
  }
  const auto reach = static_cast<float>(1.5 * spacing_);
  return inWood_.nearestOne(local(place), reach) ? std::optional(place) : std::nullopt;
}

/// Smoothing draws places off the points in bends, and spaces them across gaps: the former go back
/// to the points, the latter are left out. Edges that still stray get a place of their own there.
Trace TraceGraph::onThePoints(const Trace& trace, const TraceEnd& from, const TraceEnd& to) const {
  if (spacing_ == 0) return trace;
  const std::size_t last = trace.places.size() - 1;
  const std::vector<double> wood = filled(trace.radii);
  Trace result;
  const auto add = [&](const Eigen::Vector3d& place, double radius) {
    result.places.push_back(place);
    result.radii.push_back(radius);
  };
  for (std::size_t i = 0; i <= last; ++i) {
    const bool isFixed = (i == 0 && from.isFixed) || (i == last && to.isFixed);
    const bool isEnd = i == 0 || i == last;
    const auto place = isFixed ? trace.places[i] : onPoints(trace.places[i], wood[i]);
    if (!place && !isEnd) continue;
    if (i > 0)
      if (const auto between = strayOn({result.places.back(), place.value_or(trace.places[i])},
                                       std::max(wood[i - 1], wood[i])))
        add(*between, wood[i]);
    add(place.value_or(trace.places[i]), wood[i]);
  }
  return result;
}

/// Where an edge strays farthest from the points, back on them; none: nowhere, or across a gap.
std::optional<Eigen::Vector3d> TraceGraph::strayOn(const std::array<Eigen::Vector3d, 2>& edge,
                                                   double radius) const {
  const Eigen::Vector3d along = edge[1] - edge[0];
  const double steps = std::clamp(std::ceil(2 * along.norm() / spacing_), 1.0, 1000.0);
  double farthest = radius + 1.5 * spacing_;
  std::optional<Eigen::Vector3d> stray;
  for (double i = 1; i < steps; ++i) {
    const Eigen::Vector3d place = edge[0] + i / steps * along;
    const double distance = toPoints(place);
    if (distance <= farthest) continue;
    farthest = distance;
    stray = place;
  }
  const bool isInGap = farthest > 4 * spacing_;
  if (!stray || isInGap) return std::nullopt;
  const auto place = onPoints(*stray, radius);
  const double shortest = spacing_; // shorter edges only make a trace turn
  const bool isApart = (*place - edge[0]).norm() > shortest && (*place - edge[1]).norm() > shortest;
  return isApart ? place : std::nullopt;
}

} // namespace espalier
