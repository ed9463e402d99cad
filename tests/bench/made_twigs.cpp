#include "tests/bench/made_twigs.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/pipeline/grow_branches.h"
#include "core/pipeline/regrow.h"
#include "core/reconstruct/leave_wood.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// The place of some nodes' edges that is nearest.
NearestPlace nearestOn(const Skeleton& skeleton, const Vector3d& place) {
  return *EdgeIndex(skeleton).nearest(place);
}

/// Adds a branch as the tools do that trace it; a node that it puts on an edge of wood that was
/// made before is one of that.
void addLine(Made& made, const Trace& trace) {
  SkeletonEditor editor(made.plant);
  NodeId at = addTrace(editor, trace);
  (void)editor.commit();
  const auto isAdded = [&](NodeId id) { return std::ranges::count(made.added, id) > 0; };
  std::vector<NodeId> line;
  for (std::size_t i = 1; i < trace.places.size(); ++i, at = *made.plant[at].parent)
    line.push_back(at);
  if (const auto below = made.plant[at].parent; below && isAdded(*below) && !isAdded(at))
    made.added.push_back(at);
  made.added.insert(made.added.end(), line.begin(), line.end());
}

/// What a trace is asked for with.
TraceOptions optionsOf(const Subject& subject, const Skeleton& plant, bool isStroke) {
  return {.step = subject.step,
          .alternatives = 0,
          .wood = std::make_shared<const EdgeIndex>(bodiesOf(plant)),
          .keepsStart = isStroke};
}

/// What a hand makes of a twig at once: from the node that bears it to a tip.
struct Chain {
  std::vector<NodeId> nodes;
  std::vector<Eigen::Index> points; // that show it, nearest the tip first
};

/// All of a twig, one after another, but for those that hardly any points show.
std::vector<Chain> chainsOf(const Subject& subject, const Twig& twig) {
  constexpr std::size_t fewest = 4; // points
  const Skeleton& truth = subject.plant.truth;
  std::vector<EdgeBody> wood = bodiesOf(truth);
  std::erase_if(
      wood, [&](const EdgeBody& edge) { return std::ranges::count(twig.nodes, edge.node) == 0; });
  const EdgeIndex index(wood);
  std::vector<Chain> chains;
  for (const NodeId id : twig.nodes) {
    if (id != twig.first && nextOnAxis(truth, *truth[id].parent) == id) continue;
    Chain chain{.nodes = {*truth[id].parent, id}, .points = {}};
    while (const auto next = nextOnAxis(truth, chain.nodes.back()))
      chain.nodes.push_back(*next);
    for (const Eigen::Index point : twig.points) {
      const NodeId nearest = index.nearest(subject.cloud->position(point))->node;
      if (std::find(chain.nodes.begin() + 1, chain.nodes.end(), nearest) != chain.nodes.end())
        chain.points.push_back(point);
    }
    std::ranges::sort(chain.points, {}, [&](Eigen::Index point) {
      return (subject.cloud->position(point) - truth[chain.nodes.back()].position).squaredNorm();
    });
    if (id == twig.first || chain.points.size() >= fewest) chains.push_back(std::move(chain));
  }
  return chains;
}

/// Where a click on the bearer lands that is meant for a place of it.
NearestPlace clickedOn(const Subject& subject, const Skeleton& plant, const Vector3d& place,
                       Random& random) {
  const NearestPlace at = nearestOn(plant, place);
  const Node& node = plant[at.node];
  Vector3d along = at.along;
  if (along.isZero(0) && node.parent) along = node.position - plant[*node.parent].position;
  const double aside = (random.uniform() < 0.5 ? -4 : 4) * subject.spacing;
  return nearestOn(plant, at.position + aside * along.normalized());
}

Made traced(const Subject& subject, const Twig& twig, Random& random) {
  Made made{subject.plant.pruned, {}};
  const Skeleton& truth = subject.plant.truth;
  for (const Chain& chain : chainsOf(subject, twig)) {
    const NearestPlace on =
        clickedOn(subject, made.plant, truth[chain.nodes.front()].position, random);
    if (chain.points.empty()) continue;
    const Vector3d end = subject.cloud->position(chain.points.front());
    addLine(made,
            subject.graph
                ->between({on.position, true}, {end, false}, optionsOf(subject, made.plant, false))
                .front());
  }
  return made;
}

/// Points as they are seen from one side, and picked there.
class Sight {
public:
  Sight(const PointCloud& cloud, const std::vector<Eigen::Index>& points, const Vector3d& toViewer)
      : cloud_(cloud), points_(points), toViewer_(toViewer),
        flat_(cloud.positions()(Eigen::all, points)), index_(flattened(flat_, toViewer)) {}
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  /// The frontmost point within a reach about a place as it is seen.
  [[nodiscard]] std::optional<Eigen::Index> pick(const Vector3d& place, double reach) const {
    Eigen::Matrix3Xf seen = (place - cloud_.origin()).cast<float>();
    flattened(seen, toViewer_);
    std::optional<Eigen::Index> best;
    double nearest = 0;
    for (const Neighbor& near : index_.within(seen.col(0), static_cast<float>(reach))) {
      const Eigen::Index point = points_[static_cast<std::size_t>(near.index)];
      const double depth = toViewer_.dot(cloud_.position(point));
      if (best && depth <= nearest) continue;
      best = point;
      nearest = depth;
    }
    return best;
  }

private:
  static Eigen::Matrix3Xf& flattened(Eigen::Matrix3Xf& places, const Vector3d& toViewer) {
    const Eigen::Vector3f normal = toViewer.cast<float>();
    for (Eigen::Index i = 0; i < places.cols(); ++i)
      places.col(i) -= normal.dot(places.col(i)) * normal;
    return places;
  }

  const PointCloud& cloud_;
  const std::vector<Eigen::Index>& points_;
  Vector3d toViewer_;
  Eigen::Matrix3Xf flat_;
  SpatialIndex index_;
};

/// Points as near to a twig as one sees it in the focus of the view.
std::vector<Eigen::Index> pointsAbout(const Subject& subject, const Twig& twig) {
  constexpr double margin = 20; // spacings
  Eigen::AlignedBox3d box;
  for (const NodeId id : twig.nodes)
    box.extend(subject.plant.truth[id].position);
  std::vector<Eigen::Index> points;
  for (Eigen::Index i = 0; i < subject.cloud->size(); ++i)
    if (box.exteriorDistance(subject.cloud->position(i)) <= margin * subject.spacing)
      points.push_back(i);
  return points;
}

/// Places that a hand leads along, a spacing or more apart.
std::vector<Vector3d> handOver(const Skeleton& truth, const std::vector<NodeId>& chain,
                               double spacing, const Vector3d& toViewer, Random& random) {
  std::vector<Vector3d> places;
  const double step = 2 * spacing;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vector3d from = truth[chain[i - 1]].position;
    const Vector3d along = truth[chain[i]].position - from;
    const auto parts = static_cast<int>(std::clamp(std::ceil(along.norm() / step), 1.0, 1000.0));
    for (int part = 0; part < parts; ++part) {
      Vector3d aside = spacing * random.normal() * random.direction();
      aside -= aside.dot(toViewer) * toViewer;
      places.push_back(from + (part + 0.5) / parts * along + aside);
    }
  }
  return places;
}

Made stroked(const Subject& subject, const Twig& twig, Random& random) {
  Made made{subject.plant.pruned, {}};
  const Skeleton& truth = subject.plant.truth;
  const PointCloud& cloud = *subject.cloud;
  constexpr double reach = 2; // spacings about the pointer
  const std::vector<Eigen::Index> about = pointsAbout(subject, twig);
  for (const Chain& chain : chainsOf(subject, twig)) {
    const Vector3d along =
        (truth[chain.nodes.back()].position - truth[chain.nodes.front()].position).normalized();
    std::size_t mostSeen = 0;
    std::unique_ptr<const Sight> best;
    std::vector<Vector3d> hand;
    constexpr int sides = 8;
    for (int side = 0; side < sides; ++side) {
      const Vector3d toViewer =
          Eigen::AngleAxisd(2 * std::numbers::pi * side / sides, along) * along.unitOrthogonal();
      auto sight = std::make_unique<const Sight>(cloud, about, toViewer);
      std::vector<Vector3d> places =
          handOver(truth, chain.nodes, subject.spacing, toViewer, random);
      std::size_t seen = 0;
      for (const Vector3d& place : places)
        if (const auto point = sight->pick(place, reach * subject.spacing))
          seen += std::ranges::binary_search(twig.points, *point) ? 1 : 0;
      if (best && seen <= mostSeen) continue;
      mostSeen = seen;
      best = std::move(sight);
      hand = std::move(places);
    }
    const NearestPlace on = nearestOn(made.plant, truth[chain.nodes.front()].position);
    std::vector<Vector3d> places = {on.position};
    for (const Vector3d& place : hand) { // as the tool takes them
      const auto point = best->pick(place, reach * subject.spacing);
      if (!point) continue;
      const double slack =
          4 * subject.spacing + (places.size() == 1 ? 2 * made.plant[on.node].radius : 0);
      const Vector3d picked = cloud.position(*point);
      if ((picked - places.back()).norm() <= 4 * (place - places.back()).norm() + slack)
        places.push_back(picked);
    }
    if (places.size() < 2) continue;
    Trace trace = subject.graph->through(places, true, optionsOf(subject, made.plant, true));
    trace.begin = {on.node, on.share};
    addLine(made, trace);
  }
  return made;
}

std::vector<NodeId> newNodes(const Skeleton& after, const Skeleton& before,
                             const std::vector<NodeId>& first) {
  std::vector<NodeId> added = downstream(after, first);
  std::erase_if(added, [&](NodeId id) { return before.contains(id); });
  return added;
}

Made withGrown(const Skeleton& plant, const std::vector<GrownBranch>& branches) {
  Made made{plant, {}};
  SkeletonEditor editor(made.plant);
  for (const std::vector<NodeId>& first : addGrown(editor, branches))
    made.added.insert(made.added.end(), first.begin(), first.end());
  (void)editor.commit();
  made.added = newNodes(made.plant, plant, made.added);
  return made;
}

std::optional<Made> regrownTwig(const Subject& subject, const Twig& twig) {
  if (twig.nodes.size() < 2) return std::nullopt;
  Made made{subject.plant.pruned, {}};
  Skeleton plant = subject.plant.truth;
  for (auto id = twig.nodes.rbegin(); *id != twig.first; ++id)
    plant.erase(*id);
  const Skeleton part = regrown(plant, twig.first, subject.cloud);
  made.plant = plant;
  SkeletonEditor editor(made.plant);
  const std::vector<NodeId> first = addCarried(editor, twig.first, part);
  (void)editor.commit();
  made.added = newNodes(made.plant, plant, first);
  return made;
}

} // namespace

std::optional<Made> madeBy(Tool tool, const Subject& subject, const Twig& twig, Random& random) {
  try {
    switch (tool) {
    case Tool::trace:
      return traced(subject, twig, random);
    case Tool::stroke:
      return stroked(subject, twig, random);
    case Tool::regrow:
      return regrownTwig(subject, twig);
    case Tool::points:
      return withGrown(subject.plant.pruned,
                       grownBranches(subject.plant.pruned, subject.cloud, twig.points));
    case Tool::missing:
      return withGrown(subject.plant.pruned,
                       grownFromUnexplained(subject.plant.pruned, subject.cloud));
    }
  } catch (const Error&) { // it makes nothing
  }
  return Made{subject.plant.pruned, {}};
}

} // namespace espalier
