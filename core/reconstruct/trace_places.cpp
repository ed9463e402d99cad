// How a fine line through the middle of the wood becomes the places of a trace.
#include "core/reconstruct/centered_line.h"
#include "core/reconstruct/trace.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

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
