#include "tests/bench/judged_twigs.h"

#include "core/base/random.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/point_distances.h"
#include "core/skeleton/select.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// Calls visit(place, share of the edge, length it stands for) evenly along an edge.
template <class Visit> void alongEdge(const Frustum& edge, double step, const Visit& visit) {
  const auto parts = static_cast<int>(std::clamp(std::ceil(edge.length() / step), 1.0, 10'000.0));
  for (int i = 0; i < parts; ++i) {
    const double share = (i + 0.5) / parts;
    visit(edge.at(share), share, edge.length() / parts);
  }
}

double turnBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

std::vector<EdgeBody> bodiesOf(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<EdgeBody> bodies;
  for (const NodeId id : ids)
    if (skeleton[id].parent)
      if (const auto body = frustumOf(skeleton, id)) bodies.push_back({id, *body});
  return bodies;
}

/// Where new wood leaves what bears it.
Vector3d footOf(const Skeleton& made, const std::vector<NodeId>& added) {
  const auto lowest = std::ranges::find_if(added, [&](NodeId id) {
    return made[id].parent && std::ranges::count(added, *made[id].parent) == 0;
  });
  return lowest == added.end() ? made[added.front()].position
                               : made[*made[*lowest].parent].position;
}

} // namespace

PrunedPlant withoutTwigs(const Skeleton& truth, const std::shared_ptr<const PointCloud>& cloud,
                         double spacing, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t fewest = 8; // points that show a twig
  PrunedPlant plant{.truth = truth, .pruned = truth, .twigs = {}};
  Random random(seed);
  const PointDistances distances(cloud, spacing, truth);
  std::vector<std::vector<Eigen::Index>> pointsOf(truth.idEnd());
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (const auto k = static_cast<std::size_t>(i); distances.toSurface()[k] < 3 * spacing)
      pointsOf[indexOf(distances.nearest()[k])].push_back(i);
  const EdgeIndex wood(espalier::bodiesOf(truth));
  std::vector<NodeId> candidates = truth.ids();
  for (std::size_t i = candidates.size(); i > 1; --i) // Fisher and Yates
    std::swap(candidates[i - 1], candidates[random.below(i)]);
  std::vector<bool> isTaken(truth.idEnd(), false);
  for (const NodeId id : candidates) {
    if (plant.twigs.size() == count) break;
    const auto parent = truth[id].parent;
    if (!parent || nextOnAxis(truth, *parent) == id || isTaken[indexOf(*parent)]) continue;
    Twig twig{.first = id, .nodes = downstream(truth, {id}), .points = {}};
    const auto isOf = [&](NodeId node) { return std::ranges::count(twig.nodes, node) > 0; };
    const auto tips = std::ranges::count_if(
        twig.nodes, [&](NodeId node) { return truth.children(node).empty(); });
    if (tips > 3 || std::ranges::any_of(twig.nodes, [&](NodeId n) { return isTaken[indexOf(n)]; }))
      continue;
    std::size_t shown = 0;
    for (const NodeId node : twig.nodes)
      for (const Eigen::Index point : pointsOf[indexOf(node)]) {
        twig.points.push_back(point);
        if (wood.distanceToSurface(cloud->position(point),
                                   [&](NodeId other) { return !isOf(other); }) > 3 * spacing)
          ++shown;
      }
    if (shown < fewest) continue;
    std::ranges::sort(twig.points);
    for (const NodeId node : twig.nodes)
      isTaken[indexOf(node)] = true;
    isTaken[indexOf(*parent)] = true; // it stays
    for (auto node = twig.nodes.rbegin(); node != twig.nodes.rend(); ++node)
      plant.pruned.erase(*node);
    plant.twigs.push_back(std::move(twig));
  }
  return plant;
}

TwigJudge::TwigJudge(const PrunedPlant& plant, const PointCloud& cloud, double spacing)
    : plant_(plant), cloud_(cloud), spacing_(spacing), points_(cloud.positions()),
      truth_(espalier::bodiesOf(plant.truth)), pruned_(espalier::bodiesOf(plant.pruned)) {}

TwigScore TwigJudge::score(const Twig& twig, const Skeleton& made,
                           const std::vector<NodeId>& added) const {
  TwigScore score;
  const double step = 0.5 * spacing_;
  std::vector<NodeId> wanted = twig.nodes; // what was not there already
  std::erase_if(wanted,
                [&](NodeId id) { return made.contains(id) && made[id] == plant_.truth[id]; });
  const EdgeIndex twigs(bodiesOf(plant_.truth, wanted));
  const EdgeIndex grown(bodiesOf(made, added));
  const auto all = [](NodeId) { return true; };
  const auto isInOther = [&](const Vector3d& place) {
    return pruned_.distanceToSurface(place, all) == 0;
  };
  for (const EdgeBody& edge : twigs.edges())
    alongEdge(edge.body, step, [&](const Vector3d& place, double share, double length) {
      const double radius = edge.body.radiusAt(share);
      if (isInOther(place) || !isSeen(place, radius)) return;
      score.length += length;
      const double most = std::max(radius / 2, 1.5 * spacing_);
      if (!added.empty() && grown.distance(place, all) <= most) score.found += length;
    });
  for (const EdgeBody& edge : grown.edges()) {
    alongEdge(edge.body, step, [&](const Vector3d& place, double, double length) {
      const auto nearest = twigs.nearest(place);
      double most = 1.5 * spacing_;
      if (nearest) {
        const auto wood = frustumOf(plant_.truth, nearest->node);
        if (wood) most = std::max(most, wood->radiusAt(nearest->share) / 2);
      }
      const bool isNear = nearest && nearest->distance <= most;
      const double toOther = pruned_.distanceToSurface(place, all);
      if (toOther > 0) {
        score.grown += length;
        if (isNear) score.near += length;
      }
      if (!isNear && toOther <= spacing_) score.skin += length;
    });
    score.air = std::max(score.air, airOn(edge.body));
    const NodeId below = *made[edge.node].parent;
    if (made[below].parent)
      score.sharpest = std::max(
          score.sharpest, turnBetween(made[below].position - made[*made[below].parent].position,
                                      made[edge.node].position - made[below].position));
  }
  if (!added.empty() && wanted.size() == twig.nodes.size())
    score.begins =
        (footOf(made, added) - plant_.truth[*plant_.truth[twig.first].parent].position).norm();
  return score;
}

bool TwigJudge::isSeen(const Vector3d& place, double radius) const {
  return points_
      .nearestOne((place - cloud_.origin()).cast<float>(),
                  static_cast<float>(radius + 2 * spacing_))
      .has_value();
}

double TwigJudge::airOn(const Frustum& edge) const {
  double longest = 0;
  double stretch = 0;
  alongEdge(edge, 0.5 * spacing_, [&](const Vector3d& place, double share, double length) {
    const bool isAir = !isSeen(place, edge.radiusAt(share)) &&
                       truth_.distanceToSurface(place, [](NodeId) { return true; }) > 3 * spacing_;
    stretch = isAir ? stretch + length : 0;
    longest = std::max(longest, stretch);
  });
  return longest;
}

} // namespace espalier
