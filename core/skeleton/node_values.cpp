#include "core/skeleton/node_values.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

using Values = std::vector<std::optional<double>>;

/// Points whose nearest surface is that of a node's edge.
struct Share {
  double sum = 0; // of distances to the surface [L]
  double all = 0;
  double near = 0; // those that lie on it
};

std::vector<Share> shares(const Skeleton& skeleton, const PointDistances& distances,
                          double spacing) {
  constexpr double onSurface = 4; // spacings
  std::vector<Share> result(skeleton.idEnd());
  for (std::size_t i = 0; i < distances.toSurface().size(); ++i) {
    const double distance = std::abs(distances.toSurface()[i]);
    if (!std::isfinite(distance)) continue;
    Share& share = result[indexOf(distances.nearest()[i])];
    share.sum += distance;
    share.all += 1;
    if (distance <= onSurface * spacing) share.near += 1;
  }
  return result;
}

std::optional<double> confidence(const Share& share, const Frustum& body, double spacing) {
  const double area = body.lateralArea();
  if (area <= 0) return std::nullopt;
  return std::min(1.0, share.near * 4 * spacing * spacing / area);
}

std::optional<double> radiusToParent(const Skeleton& skeleton, const Node& node) {
  if (!node.parent || skeleton[*node.parent].radius <= 0) return std::nullopt;
  return node.radius / skeleton[*node.parent].radius;
}

} // namespace

Values nodeValues(const Skeleton& skeleton, NodeValue value, const PointDistances* distances,
                  double spacing) {
  Values result(skeleton.idEnd());
  const bool isOfPoints = value == NodeValue::distance || value == NodeValue::confidence;
  if (isOfPoints && distances == nullptr) return result;
  const std::vector<Share> shared =
      isOfPoints ? shares(skeleton, *distances, spacing) : std::vector<Share>();
  const std::vector<int> order = orders(skeleton);
  for (const NodeId id : skeleton.ids()) {
    const std::size_t i = indexOf(id);
    const Node& node = skeleton[id];
    switch (value) {
    case NodeValue::distance:
      if (shared[i].all > 0) result[i] = shared[i].sum / shared[i].all;
      break;
    case NodeValue::order:
      result[i] = order[i];
      break;
    case NodeValue::radius:
      if (node.radius > 0) result[i] = node.radius;
      break;
    case NodeValue::radiusToParent:
      result[i] = radiusToParent(skeleton, node);
      break;
    case NodeValue::radiusSpread:
      if (node.origin.hasInterval()) result[i] = (node.origin.most - node.origin.least) / 2;
      break;
    case NodeValue::confidence:
      if (const auto body = frustumOf(skeleton, id))
        result[i] = confidence(shared[i], *body, spacing);
      break;
    }
  }
  return result;
}

} // namespace espalier
