#include "core/pipeline/grow_branches.h"

#include "core/base/error.h"
#include "core/base/spatial_index.h"
#include "core/graph/components.h"
#include "core/pipeline/grow_part.h"
#include "core/skeleton/branch_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr int neighbors = 12;

/// A link by which a part may hang: on the plant, or on another part.
struct Link {
  double length = std::numeric_limits<double>::infinity(); // [L]
  std::size_t from = 0;                                    // the part
  std::optional<std::size_t> to;                           // the other part; none: the plant
  Eigen::Index at = 0;                                     // its point that is nearest
};

struct Part {
  std::vector<Eigen::Index> points; // among those asked for, ascending
  Link toPlant;
  double farthest = 0; // of its points from the wood of the plant [L]
};

/// Where a part has been hung, and what grew there.
struct Hung {
  NodeId on;                 // node of the plant at the foot of all
  std::vector<NodeId> nodes; // of this part, in the tree on that node
};

/// What grows: parts, one after another.
class Growth {
public:
  /// @param leastReach  [L] parts that nowhere lie farther off the plant are its bark, not branches
  Growth(const Skeleton& skeleton, const PointCloud& cloud, std::vector<Eigen::Index> points,
         const GrowOptions& options, double leastReach)
      : skeleton_(skeleton), cloud_(cloud), points_(std::move(points)), options_(options.pipeline),
        whole_(scaleOf(cloud, options.pipeline.up)),
        gap_(options.widestGap > 0 ? options.widestGap : 8 * whole_.spacing),
        join_(options.widestJoin > 0 ? options.widestJoin : whole_.height / 10),
        leastReach_(leastReach), positions_(cloud.positions()(Eigen::all, points_)) {}

  std::vector<GrownBranch> grow(const Progress& progress) {
    findParts(progress.part(0, 0.3));
    measure(progress.part(0.3, 0.4));
    const std::vector<Link> links = linksInOrder();
    double done = 0;
    double all = 0;
    for (const Link& link : links)
      all += static_cast<double>(parts_[link.from].points.size());
    hung_.resize(parts_.size());
    for (const Link& link : links) {
      const double next = done + static_cast<double>(parts_[link.from].points.size());
      hang(link, progress.part(0.4 + 0.6 * done / all, 0.4 + 0.6 * next / all));
      done = next;
    }
    std::vector<GrownBranch> result;
    for (auto& [on, tree] : trees_)
      result.push_back({NodeId{on}, std::move(tree)});
    return result;
  }

private:
  void findParts(const Progress& progress) {
    const NeighborhoodGraph near(positions_, neighbors, progress.part(0, 0.6));
    const NeighborhoodGraph graph =
        joined(near, positions_, static_cast<float>(gap_), progress.part(0.6, 1));
    std::vector<bool> isMet(points_.size(), false);
    for (std::size_t first = 0; first < points_.size(); ++first) {
      if (isMet[first]) continue;
      std::vector<Eigen::Index> met = {static_cast<Eigen::Index>(first)};
      isMet[first] = true;
      for (std::size_t next = 0; next < met.size(); ++next)
        for (const NeighborhoodGraph::Link& link : graph.links(met[next])) {
          // The nearest neighbors of points that stand alone are far off.
          if (static_cast<double>(link.length) > gap_ || isMet[link.to]) continue;
          isMet[link.to] = true;
          met.push_back(link.to);
        }
      if (met.size() < fewestPoints) continue;
      std::ranges::sort(met);
      parts_.push_back({std::move(met)});
    }
  }

  void measure(const Progress& progress) {
    const std::vector<PointByTube> places =
        pointsByTube(positions_, cloud_.origin(), skeleton_, progress);
    for (Part& part : parts_)
      for (const Eigen::Index point : part.points) {
        const double distance = std::max(places[static_cast<std::size_t>(point)].distance, 0.0);
        part.farthest = std::max(part.farthest, distance);
        if (distance < part.toPlant.length) part.toPlant = {distance, 0, std::nullopt, point};
      }
    std::erase_if(parts_, [&](const Part& part) { return part.farthest < leastReach_; });
    for (std::size_t k = 0; k < parts_.size(); ++k)
      parts_[k].toPlant.from = k;
  }

  /// The shortest link from each part to a point of another one that is nearer than the plant.
  [[nodiscard]] std::vector<Link> linksBetween() const {
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> partOf(points_.size(), none);
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (const Eigen::Index point : parts_[k].points)
        partOf[static_cast<std::size_t>(point)] = k;
    const SpatialIndex index(positions_);
    std::vector<Link> links;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      Link best{std::min(parts_[k].toPlant.length, join_), k, std::nullopt, 0};
      const auto isOfAnother = [&](Eigen::Index i) {
        const std::size_t part = partOf[static_cast<std::size_t>(i)];
        return part != none && part != k;
      };
      for (const Eigen::Index point : parts_[k].points) {
        const auto found =
            index.nearestIf(positions_.col(point), static_cast<float>(best.length), isOfAnother);
        if (!found) continue;
        best = {std::sqrt(static_cast<double>(found->squaredDistance)), k,
                partOf[static_cast<std::size_t>(found->index)], point};
      }
      if (best.to) links.push_back(best);
    }
    return links;
  }

  /// One link per part that is near enough, so that each comes after the one it hangs on: the
  /// shortest ones that hold all together with the plant (Kruskal).
  [[nodiscard]] std::vector<Link> linksInOrder() const {
    std::vector<Link> all = linksBetween();
    for (const Part& part : parts_)
      if (part.toPlant.length <= join_) all.push_back(part.toPlant);
    std::ranges::stable_sort(all, {}, &Link::length);
    std::vector<std::size_t> group(parts_.size() + 1); // the last is the plant
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto root = [&](std::size_t of) {
      while (group[of] != of)
        of = group[of] = group[group[of]];
      return of;
    };
    std::vector<Link> taken;
    for (const Link& link : all) {
      const std::size_t a = root(link.from);
      const std::size_t b = root(link.to.value_or(parts_.size()));
      if (a == b) continue;
      group[a] = b;
      taken.push_back(link);
    }
    return fromThePlantOn(std::move(taken));
  }

  /// Links may have been found from either end: turns them to lead away from the plant.
  [[nodiscard]] std::vector<Link> fromThePlantOn(std::vector<Link> links) const {
    std::vector<bool> isHung(parts_.size(), false);
    std::vector<Link> ordered;
    bool goesOn = true;
    while (goesOn) {
      goesOn = false;
      for (Link& link : links) {
        if (link.to && isHung[link.from] && !isHung[*link.to])
          link = {link.length, *link.to, link.from, nearestOf(*link.to, link.at)};
        if (isHung[link.from] || (link.to && !isHung[*link.to])) continue;
        isHung[link.from] = true;
        ordered.push_back(link);
        goesOn = true;
      }
    }
    return ordered;
  }

  /// The point of a part that is nearest to a point of another.
  [[nodiscard]] Eigen::Index nearestOf(std::size_t part, Eigen::Index to) const {
    return *std::ranges::min_element(parts_[part].points, {}, [&](Eigen::Index point) {
      return (positions_.col(point) - positions_.col(to)).squaredNorm();
    });
  }

  [[nodiscard]] Eigen::Vector3d place(Eigen::Index point) const {
    return positions_.col(point).cast<double>() + cloud_.origin();
  }

  /// Of `nodes`, the one whose wood is nearest to a place.
  static NodeId nearestWood(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                            const Eigen::Vector3d& place) {
    return *std::ranges::min_element(nodes, {}, [&](NodeId id) {
      return (skeleton[id].position - place).norm() - skeleton[id].radius;
    });
  }

  /// The node that a part hangs on: the nearest, or if the part would begin backward, the nearest
  /// of those linked with it from which it leads ahead.
  [[nodiscard]] NodeId bearerOf(const Part& part, const Eigen::Vector3d& foot) const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Index point : part.points)
      middle += place(point) / static_cast<double>(part.points.size());
    const auto leadsAhead = [&](NodeId id) {
      return (foot - skeleton_[id].position).dot(middle - foot) >= 0;
    };
    const NodeId nearest = nearestWood(skeleton_, skeleton_.ids(), foot);
    if (leadsAhead(nearest)) return nearest;
    std::vector<NodeId> linked = skeleton_.children(nearest);
    if (skeleton_[nearest].parent) linked.push_back(*skeleton_[nearest].parent);
    std::erase_if(linked, [&](NodeId id) { return !leadsAhead(id); });
    return linked.empty() ? nearest : nearestWood(skeleton_, linked, foot);
  }

  void hang(const Link& link, const Progress& progress) {
    const Eigen::Vector3d foot = place(link.at);
    std::vector<Eigen::Index> columns;
    for (const Eigen::Index point : parts_[link.from].points)
      columns.push_back(points_[static_cast<std::size_t>(point)]);
    Skeleton grown;
    try {
      grown = grownPart(cloud_, columns, foot, whole_, options_, progress);
    } catch (const Error&) { // the pipeline makes no plant of it: too few points along it
      return;
    }
    if (grown.isEmpty()) return;
    const std::optional<Hung> below = link.to ? hung_[*link.to] : std::nullopt;
    const NodeId on = below ? below->on : bearerOf(parts_[link.from], foot);
    Skeleton& tree = treeOn(on);
    const NodeId node = below ? nearestWood(tree, below->nodes, foot) : tree.roots().front();
    const Skeleton part = hungOn(tree[node], grown);
    if (part.size() < 2) return;
    const std::size_t before = tree.idEnd();
    SkeletonEditor editor(tree);
    (void)addCarried(editor, node, part);
    (void)editor.commit();
    Hung hung{on, {}};
    for (std::size_t id = before; id < tree.idEnd(); ++id)
      hung.nodes.push_back(NodeId{static_cast<std::uint32_t>(id)});
    hung_[link.from] = std::move(hung);
  }

  Skeleton& treeOn(NodeId on) {
    Skeleton& tree = trees_[static_cast<std::uint32_t>(on)];
    if (tree.isEmpty()) {
      const Node& node = skeleton_[on];
      (void)tree.add({.position = node.position, .radius = node.radius});
    }
    return tree;
  }

  const Skeleton& skeleton_;
  const PointCloud& cloud_;
  std::vector<Eigen::Index> points_; // columns of the cloud
  const PipelineOptions& options_;
  PlantScale whole_;
  double gap_;
  double join_;
  double leastReach_;
  Eigen::Matrix3Xf positions_; // of points_
  std::vector<Part> parts_;
  std::vector<std::optional<Hung>> hung_;   // by part; none: not yet, or nothing grew
  std::map<std::uint32_t, Skeleton> trees_; // by the node they are on
};

} // namespace

namespace {

double toleranceOf(const GrowOptions& options, const PointCloud& cloud) {
  return options.tolerance > 0 ? options.tolerance : 3 * pointSpacing(cloud.positions());
}

/// Those of some points that no edge explains; if they are too few for a branch, all.
std::vector<Eigen::Index> unexplained(const std::vector<Eigen::Index>& points,
                                      const Skeleton& skeleton, const PointCloud& cloud,
                                      double tolerance, const Progress& progress) {
  const std::vector<PointByTube> places =
      pointsByTube(cloud.positions()(Eigen::all, points), cloud.origin(), skeleton, progress);
  std::vector<Eigen::Index> left;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (places[i].distance > tolerance) left.push_back(points[i]);
  return left.size() < fewestPoints ? points : left;
}

std::vector<GrownBranch> grown(const Skeleton& skeleton, const PointCloud& cloud,
                               const std::vector<Eigen::Index>& points, const GrowOptions& options,
                               double leastReach, const Progress& progress) {
  const Error nothing("nothing grows from these points: they are too few, or too far from the "
                      "plant; choose others, or trace the branch");
  if (points.size() < fewestPoints) throw Error(nothing);
  std::vector<GrownBranch> branches =
      Growth(skeleton, cloud, points, options, leastReach).grow(progress);
  std::erase_if(branches, [](const GrownBranch& branch) { return branch.part.size() < 2; });
  if (branches.empty()) throw Error(nothing);
  return branches;
}

} // namespace

std::vector<GrownBranch> grownBranches(const Skeleton& skeleton,
                                       const std::shared_ptr<const PointCloud>& cloud,
                                       const std::vector<Eigen::Index>& points,
                                       const GrowOptions& options, const Progress& progress) {
  assert(!skeleton.isEmpty());
  const std::vector<Eigen::Index> left =
      unexplained(points, skeleton, *cloud, toleranceOf(options, *cloud), progress.part(0, 0.1));
  return grown(skeleton, *cloud, left, options, 0, progress.part(0.1, 1));
}

std::vector<GrownBranch> grownFromUnexplained(const Skeleton& skeleton,
                                              const std::shared_ptr<const PointCloud>& cloud,
                                              const GrowOptions& options,
                                              const Progress& progress) {
  const double tolerance = toleranceOf(options, *cloud);
  const std::vector<Eigen::Index> points =
      freePoints(skeleton, *cloud, options.pipeline.leftOut, tolerance, {}, progress.part(0, 0.2));
  if (points.size() < fewestPoints)
    throw Error("the skeleton explains all points: there is nothing to grow");
  return grown(skeleton, *cloud, points, options, 2 * tolerance, progress.part(0.2, 1));
}

} // namespace espalier
