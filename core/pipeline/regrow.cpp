#include "core/pipeline/regrow.h"

#include "core/base/error.h"
#include "core/base/spatial_index.h"
#include "core/graph/components.h"
#include "core/pipeline/attach_grown.h"
#include "core/pipeline/grow_part.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// By id: what `node` carries.
std::vector<bool> carriedBy(const Skeleton& skeleton, NodeId node) {
  std::vector<bool> isCarried(skeleton.idEnd(), false);
  for (const NodeId id : downstream(skeleton, {node}))
    isCarried[indexOf(id)] = id != node;
  return isCarried;
}

/// A node with what it carries, by itself.
Skeleton partOf(const Skeleton& skeleton, NodeId node) {
  Skeleton part;
  std::vector<NodeId> copies(skeleton.idEnd());
  for (const NodeId id : downstream(skeleton, {node})) {
    Node copy = skeleton[id];
    if (id == node)
      copy.parent.reset();
    else
      copy.parent = copies[indexOf(*copy.parent)];
    copies[indexOf(id)] = part.add(copy);
  }
  return part;
}

bool isUnbranched(const Skeleton& skeleton) {
  return std::ranges::all_of(skeleton.ids(),
                             [&](NodeId id) { return skeleton.children(id).size() <= 1; });
}

/// Connected points; columns of the cloud, ascending.
using Piece = std::vector<Eigen::Index>;

/// Those of the points that are connected with the one nearest to the node, and pieces of them that
/// go on ahead over gaps: what was found is nearer to them than all other wood.
/// @throws Error if there is none near the node, or they are too few
std::vector<Piece> piecesAt(const Skeleton& skeleton, NodeId node, const PointCloud& cloud,
                            const std::vector<Eigen::Index>& points, double widestGap, double ahead,
                            const Progress& progress) {
  const Error nothing("no points around " + nameOf(node) +
                      " are left by the rest of the plant: choose another node");
  if (points.size() < fewestChosen) throw Error(nothing);
  const Eigen::Matrix3Xf positions = cloud.positions()(Eigen::all, points);
  const Eigen::Vector3f place = (skeleton[node].position - cloud.origin()).cast<float>();
  const Eigen::Index first = nearestPoint(positions, place);
  const double reach = 2 * skeleton[node].radius + widestGap + meanEdgeLength(skeleton);
  if (static_cast<double>((positions.col(first) - place).norm()) > std::max(reach, ahead))
    throw Error(nothing);
  const NeighborhoodGraph parts(positions, partLinks, progress.part(0, 0.5));
  const auto gap = static_cast<float>(widestGap);
  const NeighborhoodGraph graph = joined(parts, positions, gap, progress.part(0.5, 0.7));
  const std::vector<bool> isCarried = carriedBy(skeleton, node);
  const EdgeIndex wood(bodiesOf(skeleton));
  const auto isOther = [&](NodeId id) { return id != node && !isCarried[indexOf(id)]; };
  std::vector<bool> isMet(points.size(), false);
  std::vector<Piece> pieces;
  std::vector<Eigen::Index> found; // all of them, columns of positions
  const auto take = [&](Eigen::Index point) {
    Piece piece = pointsLinkedTo(graph, point, gap, isMet);
    if (piece.size() < fewestChosen) return;
    found.insert(found.end(), piece.begin(), piece.end());
    for (Eigen::Index& each : piece)
      each = points[static_cast<std::size_t>(each)];
    pieces.push_back(std::move(piece));
  };
  take(first);
  constexpr int mostPieces = 20; // of a branch
  for (int i = 0; i < mostPieces && !found.empty(); ++i) {
    progress.check();
    const Eigen::Matrix3Xf ofFound = positions(Eigen::all, found);
    const SpatialIndex index(ofFound);
    double least = ahead;
    std::optional<Eigen::Index> next; // where the nearest piece is met
    for (Eigen::Index point = 0; point < positions.cols(); ++point) {
      if (isMet[static_cast<std::size_t>(point)]) continue;
      const auto near = index.nearestOne(positions.col(point), static_cast<float>(least));
      if (!near) continue;
      const double apart = std::sqrt(static_cast<double>(near->squaredDistance));
      const Eigen::Vector3d there = positions.col(point).cast<double>() + cloud.origin();
      if (apart >= least || wood.distanceToSurface(there, isOther) <= apart) continue;
      least = apart;
      next = point;
    }
    if (!next) break;
    take(*next);
  }
  if (pieces.empty()) throw Error(nothing);
  return pieces;
}

/// The trees that grow of all pieces.
Skeleton grownOf(const std::vector<Piece>& pieces, const auto& grow) {
  Skeleton all;
  for (const Piece& piece : pieces) {
    const Skeleton grown = grow(piece);
    std::vector<NodeId> copies(grown.idEnd());
    for (const NodeId id : grown.ids()) {
      Node copy = grown[id];
      if (copy.parent) copy.parent = copies[indexOf(*copy.parent)];
      copies[indexOf(id)] = all.add(copy);
    }
  }
  return all;
}

} // namespace

Skeleton regrown(const Skeleton& skeleton, NodeId node,
                 const std::shared_ptr<const PointCloud>& cloud, const RegrowOptions& wanted,
                 const Progress& progress) {
  assert(skeleton.contains(node));
  RegrowOptions options = wanted;
  options.pipeline = withScanCleaned(cloud, wanted.pipeline, progress.part(0, 0));
  const PlantScale whole = scaleOf(*cloud, options.pipeline.leftOut, options.pipeline.up, progress);
  const double tolerance = options.tolerance > 0 ? options.tolerance : 3 * whole.spacing;
  const double widestGap = options.widestGap > 0 ? options.widestGap : 8 * whole.spacing;
  const std::vector<bool> isCarried = carriedBy(skeleton, node);
  const std::vector<Eigen::Index> left = freePoints(skeleton, *cloud, options.pipeline.leftOut,
                                                    tolerance, isCarried, progress.part(0, 0.3));
  const double ahead = widestAhead * whole.spacing;
  const std::vector<Piece> pieces =
      piecesAt(skeleton, node, *cloud, left, widestGap, ahead, progress.part(0.3, 0.5));
  std::vector<Eigen::Index> points;
  for (const Piece& piece : pieces)
    points.insert(points.end(), piece.begin(), piece.end());
  std::ranges::sort(points);
  const Skeleton before = partOf(skeleton, node);
  const bool isChain = before.size() > 1 && isUnbranched(before);
  const double mean = meanEdgeLength(isChain ? before : skeleton);
  const double edge = mean > 0 ? mean : 9 * whole.spacing;
  const Eigen::Vector3d& foot = skeleton[node].position;
  std::vector<Skeleton> candidates = {grownOf(pieces, [&](const Piece& piece) {
    return grownOrTraced(*cloud, piece, foot, whole, options.pipeline, edge,
                         progress.part(0.5, 0.9));
  })};
  if (isChain)
    candidates.push_back(grownOf(pieces, [&](const Piece& piece) {
      return treeAlong(*cloud, piece, foot, edge, progress.part(0.9, 0.95));
    }));
  const AttachOptions attach{.spacing = whole.spacing,
                             .widestGap = widestGap,
                             .widestJoin = widestGap + meanEdgeLength(skeleton),
                             .widestAhead = ahead};
  Skeleton best;
  double least = unbounded;
  for (const Skeleton& candidate : candidates) {
    if (candidate.isEmpty()) continue;
    const auto branches =
        attached(skeleton, {node}, candidate, *cloud, attach, progress.part(0.95, 1));
    const double distance =
        branches.empty() ? unbounded : meanDistance(*cloud, points, branches.front().part);
    if (distance >= least) continue;
    least = distance;
    best = branches.front().part;
  }
  if (best.isEmpty())
    throw Error("nothing grows from " + nameOf(node) +
                ": choose another node, or prune less in the pipeline");
  const double slight = 0.25 * whole.spacing; // less is chance
  if (isChain && least > meanDistance(*cloud, points, before) + slight)
    throw Error("what " + nameOf(node) +
                " carries follows the points better than what would grow: " + "it stays as it is");
  return best;
}

} // namespace espalier
