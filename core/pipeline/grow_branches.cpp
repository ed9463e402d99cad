#include "core/pipeline/grow_branches.h"

#include "core/base/shown_message.h"
#include "core/base/spatial_index.h"
#include "core/graph/components.h"
#include "core/pipeline/grow_part.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/wood_skin.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/blades_along.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace espalier {
namespace {

double toleranceOf(const GrowOptions& options, const PlantScale& whole) {
  return options.tolerance > 0 ? options.tolerance : usualTolerance(whole);
}

PlantScale scaleOf(const PointCloud& cloud, const GrowOptions& options, const Progress& progress) {
  return espalier::scaleOf(cloud, options.pipeline.leftOut, options.pipeline.up, progress);
}

/// Connected points.
struct Part {
  std::vector<Eigen::Index> points; // among those asked for, ascending
  Eigen::Index foot = 0;            // its point that is nearest to the plant
};

/// What grows: parts, each by itself, and then attached together.
class Growth {
public:
  /// @param whole  of the cloud
  /// @param bark   by id, of the plant: points within that of its axes are bark [L]; empty: the
  ///               points were chosen by hand, and are what they are
  Growth(const Skeleton& skeleton, const PointCloud& cloud, std::vector<Eigen::Index> points,
         const GrowOptions& options, const PlantScale& whole, std::vector<double> bark)
      : skeleton_(skeleton), cloud_(cloud), points_(std::move(points)), options_(options),
        whole_(whole), gap_(options.widestGap > 0 ? options.widestGap : 6 * whole_.spacing),
        edge_(meanEdgeLength(skeleton) > 0 ? meanEdgeLength(skeleton) : 9 * whole_.spacing),
        tolerance_(toleranceOf(options, whole)), isChosen_(bark.empty()), bark_(std::move(bark)) {}

  std::vector<GrownBranch> grow(const Progress& progress) {
    findParts(progress.part(0, 0.3));
    double all = 0;
    for (const Part& part : parts_)
      all += static_cast<double>(part.points.size());
    Skeleton grown;
    double done = 0;
    for (const Part& part : parts_) {
      const double next = done + static_cast<double>(part.points.size());
      grow(part, grown, progress.part(0.3 + 0.6 * done / all, 0.3 + 0.6 * next / all));
      done = next;
    }
    if (!isChosen_ && !grown.isEmpty()) grown = offTheWood(grown);
    if (grown.isEmpty()) return {};
    const AttachOptions attach{.spacing = whole_.spacing,
                               .widestGap = gap_,
                               .widestJoin = options_.widestJoin > 0 ? options_.widestJoin : gap_,
                               .widestAhead = isChosen_ ? widestAhead * whole_.spacing : 0};
    const PointSet& leftOut = options_.pipeline.leftOut;
    const Progress last = progress.part(0.9, 1);
    if (leftOut.isEmpty()) return attached(skeleton_, skeleton_.ids(), grown, cloud_, attach, last);
    return attached(skeleton_, skeleton_.ids(), grown, without(cloud_, leftOut), attach, last);
  }

private:
  /// Each without blades along the plant, of which it may consist in part.
  void findParts(const Progress& progress) {
    connect(progress.part(0, 0.6));
    while (measure(progress.part(0.6, 0.8)))
      connect(progress.part(0.8, 1));
  }

  void connect(const Progress& progress) {
    parts_.clear();
    positions_ = cloud_.positions()(Eigen::all, points_);
    if (points_.empty()) return;
    const NeighborhoodGraph near(positions_, partLinks, progress.part(0, 0.6));
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
      if (met.size() < (isChosen_ ? fewestChosen : fewestPoints)) continue;
      std::ranges::sort(met);
      parts_.push_back({std::move(met)});
    }
  }

  /// Finds the foot of each part, and leaves out those that are the bark of the plant, as too few
  /// of their points stand off it for a branch, and points that are blades along it.
  /// @return whether parts are to be found again, of the points that are left
  bool measure(const Progress& progress) {
    if (parts_.empty()) return false;
    const std::vector<PointOnSkeleton> places =
        assignPoints(positions_, cloud_.origin(), skeleton_, progress);
    const auto toWood = [&](Eigen::Index point) {
      const PointOnSkeleton& place = places[static_cast<std::size_t>(point)];
      return place.distance - frustumRadius(skeleton_, place);
    };
    for (Part& part : parts_)
      part.foot = *std::ranges::min_element(part.points, {}, toWood);
    if (isChosen_) return false;
    const auto isOffTheBark = [&](Eigen::Index point) {
      const PointOnSkeleton& place = places[static_cast<std::size_t>(point)];
      return place.distance > bark_[indexOf(place.child)] && toWood(point) > 2 * tolerance_;
    };
    const auto offWood = [&](Eigen::Index point) {
      const PointOnSkeleton& place = places[static_cast<std::size_t>(point)];
      return PointOffWood{positions_.col(point).cast<double>() + cloud_.origin(), place.child,
                          place.distance - bark_[indexOf(place.child)]};
    };
    std::erase_if(parts_, [&](const Part& part) {
      const std::size_t least = std::min(fewestPoints, (part.points.size() + 1) / 2);
      return std::ranges::count_if(part.points, isOffTheBark) < std::ptrdiff_t(least);
    });
    std::vector<Eigen::Index> left;
    std::size_t all = 0;
    for (const Part& part : parts_) {
      std::vector<PointOffWood> points;
      std::ranges::transform(part.points, std::back_inserter(points), offWood);
      for (const std::size_t i : pointsOffBlades(skeleton_, points, whole_.spacing))
        left.push_back(points_[static_cast<std::size_t>(part.points[i])]);
      all += points.size();
    }
    if (left.size() == all) return false;
    std::ranges::sort(left);
    points_ = std::move(left);
    return true;
  }

  /// What grew without the ends that lie in the wood of the plant, and so add nothing to it.
  [[nodiscard]] Skeleton offTheWood(const Skeleton& grown) const {
    Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(grown.size()));
    const std::vector<NodeId> ids = grown.ids();
    for (std::size_t i = 0; i < ids.size(); ++i)
      places.col(static_cast<Eigen::Index>(i)) =
          (grown[ids[i]].position - cloud_.origin()).cast<float>();
    const std::vector<PointOnSkeleton> nearest = assignPoints(places, cloud_.origin(), skeleton_);
    std::vector<bool> isIn(grown.idEnd(), false);
    for (std::size_t i = 0; i < ids.size(); ++i)
      isIn[indexOf(ids[i])] = nearest[i].distance <= bark_[indexOf(nearest[i].child)];
    Skeleton result = grown;
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) // tips before what carries them
      if (isIn[indexOf(*id)] && result.children(*id).empty()) result.erase(*id);
    for (const NodeId id : ids) { // and from below
      if (!result.contains(id) || result[id].parent || !isIn[indexOf(id)]) continue;
      const std::vector<NodeId> carried = result.children(id);
      for (const NodeId child : carried)
        result.makeRoot(child);
      result.erase(id);
    }
    return result;
  }

  /// The trees of a part, added to those of others.
  void grow(const Part& part, Skeleton& to, const Progress& progress) const {
    std::vector<Eigen::Index> columns;
    for (const Eigen::Index point : part.points)
      columns.push_back(points_[static_cast<std::size_t>(point)]);
    const Eigen::Vector3d foot = positions_.col(part.foot).cast<double>() + cloud_.origin();
    Skeleton grown;
    if (isChosen_)
      grown = grownOrTraced(cloud_, columns, foot, whole_, options_.pipeline, edge_, progress);
    else
      try {
        grown = grownPart(cloud_, columns, foot, whole_, options_.pipeline, progress);
      } catch (const Error&) { // it makes no plant of them: too few points along it
      }
    std::vector<NodeId> copies(grown.idEnd());
    for (const NodeId id : grown.ids()) {
      Node copy = grown[id];
      if (copy.parent) copy.parent = copies[indexOf(*copy.parent)];
      copies[indexOf(id)] = to.add(copy);
    }
  }

  const Skeleton& skeleton_;
  const PointCloud& cloud_;
  std::vector<Eigen::Index> points_; // columns of the cloud
  const GrowOptions& options_;
  PlantScale whole_;
  double gap_;
  double edge_;      // [L], of new ones along lines
  double tolerance_; // [L]
  bool isChosen_;
  std::vector<double> bark_;   // by id
  Eigen::Matrix3Xf positions_; // of points_
  std::vector<Part> parts_;
};

/// Those of some points that no edge explains; if they are too few for a branch, all.
std::vector<Eigen::Index> unexplained(const std::vector<Eigen::Index>& points,
                                      const Skeleton& skeleton, const PointCloud& cloud,
                                      double tolerance, const Progress& progress) {
  const std::vector<PointByFrustum> places =
      pointsByFrustum(cloud.positions()(Eigen::all, points), cloud.origin(), skeleton, progress);
  std::vector<Eigen::Index> left;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (places[i].distance > tolerance) left.push_back(points[i]);
  return left.size() < std::min(fewestPoints, points.size()) ? points : left;
}

std::vector<GrownBranch> grown(const Skeleton& skeleton, const PointCloud& cloud,
                               const std::vector<Eigen::Index>& points, const GrowOptions& options,
                               const PlantScale& whole, std::vector<double> bark,
                               const Progress& progress) {
  const ShownError nothing(
      {espalier::Shown::tr("nothing grows from these points: they are too few, or too far from the "
                           "plant; choose others, or trace the branch")});
  if (points.size() < fewestChosen) throw ShownError(nothing);
  std::vector<GrownBranch> branches =
      Growth(skeleton, cloud, points, options, whole, std::move(bark)).grow(progress);
  std::erase_if(branches, [](const GrownBranch& branch) { return branch.part.size() < 2; });
  if (branches.empty()) throw ShownError(nothing);
  return branches;
}

} // namespace

std::vector<GrownBranch> grownBranches(const Skeleton& skeleton,
                                       const std::shared_ptr<const PointCloud>& cloud,
                                       const std::vector<Eigen::Index>& points,
                                       const GrowOptions& wanted, const Progress& progress) {
  assert(!skeleton.isEmpty());
  GrowOptions options = wanted;
  options.pipeline = withScanCleaned(cloud, wanted.pipeline, progress.part(0, 0));
  const PlantScale whole = scaleOf(*cloud, options, progress);
  const std::vector<Eigen::Index> left =
      unexplained(points, skeleton, *cloud, toleranceOf(options, whole), progress.part(0, 0.1));
  return grown(skeleton, *cloud, left, options, whole, {}, progress.part(0.1, 1));
}

std::vector<GrownBranch> grownFromUnexplained(const Skeleton& skeleton,
                                              const std::shared_ptr<const PointCloud>& cloud,
                                              const GrowOptions& wanted, const Progress& progress) {
  GrowOptions options = wanted;
  options.pipeline = withScanCleaned(cloud, wanted.pipeline, progress.part(0, 0));
  const PlantScale whole = scaleOf(*cloud, options, progress);
  const double tolerance = toleranceOf(options, whole);
  const std::vector<PointOnSkeleton> places =
      assignPoints(cloud->positions(), cloud->origin(), skeleton, progress.part(0, 0.4));
  std::vector<double> bark = barkReaches(skeleton, places, tolerance);
  progress.check();
  const std::vector<Eigen::Index> points =
      freePoints(*cloud, options.pipeline.leftOut, places, bark);
  if (points.size() < fewestPoints)
    throw ShownError(
        {espalier::Shown::tr("the skeleton explains all points: there is nothing to grow")});
  return grown(skeleton, *cloud, points, options, whole, std::move(bark), progress.part(0.4, 1));
}

} // namespace espalier
