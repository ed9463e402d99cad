#include "core/doubt/missing_branches.h"

#include "core/decide/end_odds.h"
#include "core/pipeline/grow_part.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/best_successor.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// Trees along clusters of points, all in one forest.
Skeleton tracedAlong(const std::vector<Finding>& clusters, const Skeleton& skeleton,
                     const DoubtSources& sources, const Progress& progress) {
  const PointCloud& cloud = *sources.distances.cloud();
  Skeleton all;
  const double edge = std::max(meanEdgeLength(skeleton), 3 * sources.scale.spacing);
  const auto share = [&](std::size_t k) {
    return static_cast<double>(k) / static_cast<double>(clusters.size());
  };
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::vector<Eigen::Index>& points = clusters[i].points;
    const auto foot = *std::ranges::min_element(points, {}, [&](Eigen::Index point) {
      return sources.distances.toSurface()[static_cast<std::size_t>(point)];
    });
    const Eigen::Vector3d start = cloud.positions().col(foot).cast<double>() + cloud.origin();
    const Skeleton traced = treeAlong(cloud, points, start, edge, TracedFrom::end,
                                      progress.part(share(i), share(i + 1)));
    std::vector<NodeId> copies(traced.idEnd());
    for (const NodeId id : traced.ids()) {
      Node copy = traced[id];
      if (copy.parent) copy.parent = copies[indexOf(*copy.parent)];
      copies[indexOf(id)] = all.add(copy);
    }
  }
  return all;
}

double gapOf(const GrownBranch& branch, const Skeleton& skeleton, double spacing) {
  const NodeId root = branch.part.roots().front();
  double least = 0;
  for (const NodeId child : branch.part.children(root)) {
    const double length = (branch.part[child].position - branch.part[root].position).norm();
    if (least == 0 || length < least) least = length;
  }
  return std::max(0.0, least - skeleton[branch.on].radius) / spacing;
}

using BranchesByNode = std::vector<std::optional<std::size_t>>; // by id; none of other wood

/// Takes the ends away that are probably no shoots, but for the most probable of each branch: a
/// question about points of leaves is one about a line, not about all lines that they would make.
void keepProbableEnds(EndsOfSkeleton& ends, const BranchesByNode& branchOf, std::size_t branches,
                      const Progress& progress) {
  constexpr double least = 0.5;
  for (double done = 0;; done += (1 - done) / 2) {
    std::vector<double> probabilities;
    std::vector<std::optional<std::size_t>> best(branches); // its most probable end
    for (std::size_t i = 0; i < ends.ends().size(); ++i) {
      probabilities.push_back(probabilityOfShoot(ends.ends()[i].evidence));
      const auto branch = branchOf[indexOf(ends.ends()[i].end.nodes.front())];
      if (branch && (!best[*branch] || probabilities[i] > probabilities[*best[*branch]]))
        best[*branch] = i;
    }
    std::map<NodeId, std::size_t> worst; // by foot
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
      const EndsOfSkeleton::End& end = ends.ends()[i];
      const auto branch = branchOf[indexOf(end.end.nodes.front())];
      if (!branch || best[*branch] == i || probabilities[i] >= least) continue;
      const auto [at, isNew] = worst.try_emplace(end.end.foot, i);
      if (!isNew && probabilities[i] < probabilities[at->second]) at->second = i;
    }
    if (worst.empty()) return;
    std::vector<std::size_t> gone;
    gone.reserve(worst.size());
    for (const auto& [foot, place] : worst)
      gone.push_back(place);
    std::ranges::sort(gone);
    ends.remove(gone, progress.part(done, (1 + done) / 2));
  }
}

/// What of a branch a plant still has: from its first nodes on, below them the root that it had.
/// Where the end is gone that an axis went on with, it goes on with another.
Skeleton partIn(const Skeleton& plant, const std::vector<NodeId>& first, const Skeleton& before) {
  Skeleton part;
  const NodeId root = part.add(before[before.roots().front()]);
  std::vector<std::optional<NodeId>> copies(plant.idEnd());
  std::vector<NodeId> kept;
  std::ranges::copy_if(first, std::back_inserter(kept),
                       [&](NodeId id) { return plant.contains(id); });
  for (const NodeId id : downstream(plant, kept)) {
    Node copy = plant[id];
    copy.parent = copies[indexOf(*copy.parent)].value_or(root);
    copies[indexOf(id)] = part.add(copy);
  }
  for (const NodeId id : part.ids()) {
    const std::vector<NodeId> children = part.children(id);
    if (id == root || children.empty() || nextOnAxis(part, id)) continue;
    part.setEdge(bestSuccessor(part, children), EdgeType::successor);
  }
  return part;
}

} // namespace

std::vector<MissingBranch> missingBranches(const Skeleton& skeleton, const DoubtSources& sources,
                                           const Progress& progress) {
  const PointCloud& cloud = *sources.distances.cloud();
  const double spacing = sources.scale.spacing;
  if (skeleton.isEmpty()) return {};
  const std::vector<Finding> clusters = pointsWithoutWood(skeleton, sources.distances, spacing,
                                                          sources.limits, progress.part(0, 0.2));
  const Skeleton traced = tracedAlong(clusters, skeleton, sources, progress.part(0.2, 0.7));
  if (traced.isEmpty()) return {};
  const double join = 10 * spacing;
  std::vector<GrownBranch> branches =
      attached(skeleton, skeleton.ids(), traced, cloud,
               {.spacing = spacing, .widestGap = join, .widestJoin = join, .widestAhead = 3 * join},
               progress.part(0.7, 0.8));
  std::erase_if(branches, [](const GrownBranch& branch) { return branch.part.size() < 2; });
  Skeleton plant = skeleton; // with them
  SkeletonEditor editor(plant);
  // All at once, as their places on edges are those of the plant without them.
  const std::vector<std::vector<NodeId>> first = addGrown(editor, branches);
  static_cast<void>(editor.commit());
  BranchesByNode branchOf(plant.idEnd());
  for (std::size_t i = 0; i < branches.size(); ++i)
    for (const NodeId id : downstream(plant, first[i]))
      branchOf[indexOf(id)] = i;
  EndsOfSkeleton ends(plant, cloud.positions(), cloud.origin(), sources.scale,
                      progress.part(0.8, 0.9));
  keepProbableEnds(ends, branchOf, branches.size(), progress.part(0.9, 1));
  std::vector<MissingBranch> missing;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    GrownBranch& branch = branches[i];
    branch.part = partIn(ends.skeleton(), first[i], branch.part);
    const double gap = gapOf(branch, skeleton, spacing);
    missing.push_back({.branch = std::move(branch), .evidence = {}, .gap = gap});
  }
  for (const EndsOfSkeleton::End& end : ends.ends()) {
    const std::optional<std::size_t> branch = branchOf[indexOf(end.end.nodes.front())];
    if (!branch) continue;
    EndEvidence& evidence = missing[*branch].evidence;
    if (end.evidence.length > evidence.length) evidence = end.evidence;
  }
  std::erase_if(missing, [](const MissingBranch& one) { return one.evidence.length == 0; });
  const auto tips = static_cast<double>(tipCount(skeleton));
  for (MissingBranch& one : missing) {
    one.share = static_cast<double>(missing.size()) / tips;
    one.ends = tips;
  }
  progress.update(1);
  return missing;
}

std::array<double, 15> featuresOf(const MissingBranch& missing) {
  std::array<double, 15> features{};
  auto next = std::ranges::copy(featuresOf(missing.evidence), features.begin()).out;
  const AllEnds& all = missing.evidence.all;
  for (const double feature : {std::log(missing.gap + 1), std::log(missing.share),
                               std::log(missing.ends), all.alone, all.aloneSpread})
    *next++ = feature;
  return features;
}

double probabilityOfWood(const MissingBranch& missing, const MissingOdds& odds) {
  return 1 / (1 + std::exp(-odds.value(featuresOf(missing))));
}

} // namespace espalier
