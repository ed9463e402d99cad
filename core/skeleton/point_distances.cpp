#include "core/skeleton/point_distances.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Eigen::Index mostInARun = 64;
constexpr double widestRun =
    16; // point spacings: a run of that many points on a flat surface is 11

double squaredDistance(const WoodTube& tube, const Eigen::Vector3d& place) {
  const Eigen::Vector3d along = tube.to - tube.from;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0 ? std::clamp(along.dot(place - tube.from) / squared, 0.0, 1.0) : 0;
  return (tube.from + share * along - place).squaredNorm();
}

Eigen::AlignedBox3d boxOf(const WoodTube& tube) {
  const Eigen::AlignedBox3d box = tube.centerBox();
  const Eigen::Vector3d wood = Eigen::Vector3d::Constant(tube.widest());
  return {box.min() - wood, box.max() + wood};
}

} // namespace

/// A tube made ready to be measured from many points.
struct PointDistances::Candidate {
  NodeId id;
  Eigen::Vector3d from;
  Eigen::Vector3d along;
  double inverse; // of the squared length; 0 without length
  double fromRadius;
  double wider; // from end to end

  Candidate(NodeId node, const WoodTube& tube)
      : id(node), from(tube.from), along(tube.to - tube.from),
        inverse(along.squaredNorm() > 0 ? 1 / along.squaredNorm() : 0), fromRadius(tube.fromRadius),
        wider(tube.toRadius - tube.fromRadius) {}
};

PointDistances::PointDistances(std::shared_ptr<const PointCloud> cloud, double spacing,
                               const Skeleton& skeleton, const Progress& progress)
    : cloud_(std::move(cloud)), toSurface_(static_cast<std::size_t>(cloud_->size())),
      toAxis_(toSurface_.size()), nearest_(toSurface_.size()), tubes_(skeleton.idEnd()), tree_({}) {
  makeRuns(spacing);
  for (const NodeId id : skeleton.ids())
    tubes_[indexOf(id)] = tubeHere(skeleton, id);
  plant();
  constexpr Eigen::Index runsAtOnce = 16;
  parallelFor(
      static_cast<Eigen::Index>(runs_.size()),
      [this](Eigen::Index i) { measure(runs_[static_cast<std::size_t>(i)]); }, progress,
      runsAtOnce);
}

std::vector<Eigen::Index> PointDistances::update(const Skeleton& skeleton,
                                                 const SkeletonDelta& delta) {
  std::vector<NodeId> touched;
  for (const SkeletonDelta::Change& change : delta.changes) {
    touched.push_back(change.id);
    for (const auto& state : {change.before, change.after}) // a parent may be a ball now, or before
      if (state && state->parent) touched.push_back(*state->parent);
    if (!skeleton.contains(change.id)) continue;
    const std::vector<NodeId>& children = skeleton.children(change.id);
    touched.insert(touched.end(), children.begin(), children.end());
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  tubes_.resize(skeleton.idEnd());
  isLoose_.resize(skeleton.idEnd(), false);
  std::erase_if(touched, [&](NodeId id) { // a mark, an entity, a comment: nothing to measure
    std::optional<WoodTube> tube;
    if (skeleton.contains(id)) tube = tubeHere(skeleton, id);
    const bool isSame = tube == tubes_[indexOf(id)];
    tubes_[indexOf(id)] = std::move(tube);
    return isSame;
  });
  for (const NodeId id : touched)
    if (!isLoose_[indexOf(id)]) {
      isLoose_[indexOf(id)] = true;
      loose_.insert(std::ranges::lower_bound(loose_, id), id);
    }
  constexpr std::size_t fewLoose = 64; // more would be slower than to plant the tree again
  if (loose_.size() > fewLoose) plant();

  std::vector<Run*> again;
  for (Run& run : runs_)
    if (mayChange(run, touched)) again.push_back(&run);
  parallelFor(
      static_cast<Eigen::Index>(again.size()),
      [&](Eigen::Index i) { measure(*again[static_cast<std::size_t>(i)]); }, {}, 4);
  std::vector<Eigen::Index> points;
  for (const Run* run : again)
    for (Eigen::Index i = run->begin; i < run->end; ++i)
      points.push_back(i);
  return points;
}

void PointDistances::makeRuns(double spacing) {
  const Eigen::Matrix3Xf& positions = cloud_->positions();
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const Eigen::Vector3d place = positions.col(i).cast<double>();
    if (!runs_.empty() && i - runs_.back().begin < mostInARun) {
      Eigen::AlignedBox3d box = runs_.back().box;
      box.extend(place);
      if (box.diagonal().norm() <= widestRun * spacing) {
        runs_.back().box = box;
        runs_.back().end = i + 1;
        continue;
      }
    }
    runs_.push_back({.begin = i, .end = i + 1, .box = Eigen::AlignedBox3d(place), .owners = {}});
  }
}

void PointDistances::plant() {
  planted_.clear();
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < tubes_.size(); ++i)
    if (tubes_[i]) {
      planted_.push_back(static_cast<NodeId>(i));
      boxes.push_back(boxOf(*tubes_[i]));
    }
  tree_ = BoxTree(std::move(boxes));
  isLoose_.assign(tubes_.size(), false);
  loose_.clear();
}

std::optional<WoodTube> PointDistances::tubeHere(const Skeleton& skeleton, NodeId id) const {
  std::optional<WoodTube> tube = tubeOf(skeleton, id);
  if (tube) {
    tube->from -= cloud_->origin();
    tube->to -= cloud_->origin();
  }
  return tube;
}

/// All whose axis or surface may be the nearest to a point of the run, the lowest id first.
std::vector<NodeId> PointDistances::candidates(const Run& run) const {
  const Eigen::Vector3d center = run.box.center();
  const double half = run.box.diagonal().norm() / 2;
  const auto squared = [&](std::size_t i) {
    const NodeId id = planted_[i];
    return isLoose_[indexOf(id)] ? infinite : squaredDistance(*tubes_[indexOf(id)], center);
  };
  double nearest = infinite;
  if (const auto found = tree_.nearest(center, squared)) nearest = squared(*found);
  for (const NodeId id : loose_)
    if (tubes_[indexOf(id)])
      nearest = std::min(nearest, squaredDistance(*tubes_[indexOf(id)], center));
  // No point of the run is farther than this from some axis, and none has a surface farther away.
  const double reach = std::sqrt(nearest) + half * (1 + 1e-9);
  std::vector<NodeId> ids;
  tree_.within(run.box, reach, [&](std::size_t i) {
    if (!isLoose_[indexOf(planted_[i])]) ids.push_back(planted_[i]);
  });
  for (const NodeId id : loose_)
    if (tubes_[indexOf(id)]) ids.push_back(id);
  std::ranges::sort(ids);
  return ids;
}

/// Looks at each point of the run, and at each candidate for it.
void PointDistances::measure(Run& run) {
  std::vector<Candidate> tubes;
  for (const NodeId id : candidates(run))
    tubes.emplace_back(id, *tubes_[indexOf(id)]);
  run.farthestFromAxis = run.farthestFromSurface = -infinite;
  run.owners.clear();
  for (Eigen::Index i = run.begin; i < run.end; ++i) {
    const Eigen::Vector3d place = cloud_->positions().col(i).cast<double>();
    double axis = infinite; // squared
    double surface = infinite;
    NodeId axisOf{};
    NodeId surfaceOf{};
    for (const Candidate& tube : tubes) {
      const Eigen::Vector3d off = place - tube.from;
      const double share = std::clamp(off.dot(tube.along) * tube.inverse, 0.0, 1.0);
      const double squared = (off - share * tube.along).squaredNorm();
      const double above = std::sqrt(squared) - (tube.fromRadius + share * tube.wider);
      if (squared < axis) axis = squared, axisOf = tube.id;
      if (above < surface) surface = above, surfaceOf = tube.id;
    }
    const auto k = static_cast<std::size_t>(i);
    toAxis_[k] = static_cast<float>(std::sqrt(axis));
    toSurface_[k] = static_cast<float>(surface);
    nearest_[k] = surfaceOf;
    run.farthestFromAxis = std::max(run.farthestFromAxis, std::sqrt(axis));
    run.farthestFromSurface = std::max(run.farthestFromSurface, surface);
    run.owners.push_back(axisOf);
    run.owners.push_back(surfaceOf);
  }
  std::ranges::sort(run.owners);
  run.owners.erase(std::unique(run.owners.begin(), run.owners.end()), run.owners.end());
}

/// Whether any point of the run may have become nearer or farther. pre: `touched` is sorted
bool PointDistances::mayChange(const Run& run, const std::vector<NodeId>& touched) const {
  return std::ranges::any_of(touched, [&](NodeId id) {
    if (std::ranges::binary_search(run.owners, id)) return true;
    const std::optional<WoodTube>& tube = tubes_[indexOf(id)];
    if (!tube) return false;
    const double apart = run.box.exteriorDistance(tube->centerBox());
    const double rounding = 1e-9 * (apart + tube->widest());
    return apart <= run.farthestFromAxis + rounding ||
           apart - tube->widest() <= run.farthestFromSurface + rounding;
  });
}

} // namespace espalier
