#include "core/skeleton/propose_child.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// Places of the nodes that `id` is linked to, its parent first.
std::vector<Vector3d> neighbors(const Skeleton& skeleton, NodeId id) {
  std::vector<Vector3d> places;
  if (skeleton[id].parent) places.push_back(skeleton[*skeleton[id].parent].position);
  for (const NodeId child : skeleton.children(id))
    places.push_back(skeleton[child].position);
  return places;
}

double distanceToNearest(const std::vector<Vector3d>& places, const Vector3d& from) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3d& place : places)
    least = std::min(least, (place - from).norm());
  return least;
}

Vector3d snapped(const Vector3d& place, const Vector3d& parent, const SnapToPoints& snap) {
  const Vector3d onPoints = snap(place);
  const bool leadsBack = (onPoints - parent).norm() < 0.25 * (place - parent).norm();
  return leadsBack ? place : onPoints;
}

} // namespace

Vector3d proposeChild(const Skeleton& skeleton, NodeId parent, const Vector3d& viewDirection,
                      double step, const SnapToPoints& snap) {
  assert(step > 0);
  const Vector3d here = skeleton[parent].position;
  const std::vector<Vector3d> places = neighbors(skeleton, parent);
  Vector3d forward = step * Vector3d::UnitZ();
  if (!places.empty() && (here - places[0]).norm() > 0) forward = here - places[0];
  if (skeleton.children(parent).empty()) return snapped(here + forward, here, snap);

  constexpr int candidates = 10;
  Vector3d best = here + forward;
  double farthest = -1;
  for (int i = 0; i < candidates; ++i) {
    const double angle = 2 * std::numbers::pi * i / candidates;
    const Eigen::AngleAxisd turn(angle, viewDirection.normalized());
    const Vector3d place = snapped(here + turn * forward, here, snap);
    const double distance = distanceToNearest(places, place);
    if (distance > farthest) {
      farthest = distance;
      best = place;
    }
  }
  return best;
}

} // namespace espalier
