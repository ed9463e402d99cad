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

} // namespace

/// A frustum made ready to be measured from many points.
struct PointDistances::Candidate {
  NodeId id;
  Eigen::Vector3d from;
  Eigen::Vector3d along;
  double inverse; // of the squared length; 0 without length
  double fromRadius;
  double wider; // from end to end

  Candidate(NodeId node, const Frustum& body)
      : id(node), from(body.from), along(body.to - body.from),
        inverse(along.squaredNorm() > 0 ? 1 / along.squaredNorm() : 0),
        fromRadius(inverse > 0 ? body.fromRadius : body.toRadius),
        wider(body.toRadius - fromRadius) {}
};

PointDistances::PointDistances(std::shared_ptr<const PointCloud> cloud, double spacing,
                               const Skeleton& skeleton, const Progress& progress)
    : cloud_(std::move(cloud)), toSurface_(static_cast<std::size_t>(cloud_->size())),
      nearest_(toSurface_.size()), bodies_(skeleton.idEnd()), index_(std::vector<EdgeBody>()) {
  makeRuns(spacing);
  for (const NodeId id : skeleton.ids())
    bodies_[indexOf(id)] = bodyHere(skeleton, id);
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
  bodies_.resize(skeleton.idEnd());
  isLoose_.resize(skeleton.idEnd(), false);
  std::erase_if(touched, [&](NodeId id) { // a mark, an entity, a comment: nothing to measure
    std::optional<Frustum> body;
    if (skeleton.contains(id)) body = bodyHere(skeleton, id);
    const bool isSame = body == bodies_[indexOf(id)];
    bodies_[indexOf(id)] = std::move(body);
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
  std::vector<EdgeBody> edges;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i]) edges.push_back({static_cast<NodeId>(i), *bodies_[i]});
  index_ = EdgeIndex(std::move(edges));
  isLoose_.assign(bodies_.size(), false);
  loose_.clear();
}

std::optional<Frustum> PointDistances::bodyHere(const Skeleton& skeleton, NodeId id) const {
  std::optional<Frustum> body = frustumOf(skeleton, id);
  if (body) {
    body->from -= cloud_->origin();
    body->to -= cloud_->origin();
  }
  return body;
}

/// All whose axis or surface may be the nearest to a point of the run, the lowest id first.
std::vector<NodeId> PointDistances::candidates(const Run& run) const {
  const Eigen::Vector3d center = run.box.center();
  const double half = run.box.diagonal().norm() / 2;
  const auto isPlanted = [&](NodeId id) { return !isLoose_[indexOf(id)]; };
  double nearest = index_.distance(center, isPlanted);
  for (const NodeId id : loose_)
    if (const std::optional<Frustum>& body = bodies_[indexOf(id)])
      nearest = std::min(nearest, (body->at(body->nearestShare(center)) - center).norm());
  // No point of the run is farther than this from some axis, and none has a surface farther away.
  const double reach = nearest + half * (1 + 1e-9);
  std::vector<NodeId> ids;
  index_.within(run.box, reach, [&](const EdgeBody& edge) {
    if (isPlanted(edge.node)) ids.push_back(edge.node);
  });
  for (const NodeId id : loose_)
    if (bodies_[indexOf(id)]) ids.push_back(id);
  std::ranges::sort(ids);
  return ids;
}

/// Looks at each point of the run, and at each candidate for it.
void PointDistances::measure(Run& run) {
  std::vector<Candidate> edges;
  for (const NodeId id : candidates(run))
    edges.emplace_back(id, *bodies_[indexOf(id)]);
  run.farthestFromAxis = run.farthestFromSurface = -infinite;
  run.owners.clear();
  for (Eigen::Index i = run.begin; i < run.end; ++i) {
    const Eigen::Vector3d place = cloud_->positions().col(i).cast<double>();
    double axis = infinite; // squared
    double surface = infinite;
    NodeId axisOf{};
    NodeId surfaceOf{};
    for (const Candidate& edge : edges) {
      const Eigen::Vector3d off = place - edge.from;
      const double share = std::clamp(off.dot(edge.along) * edge.inverse, 0.0, 1.0);
      const double squared = (off - share * edge.along).squaredNorm();
      const double above = std::sqrt(squared) - (edge.fromRadius + share * edge.wider);
      if (squared < axis) axis = squared, axisOf = edge.id;
      if (above < surface) surface = above, surfaceOf = edge.id;
    }
    const auto k = static_cast<std::size_t>(i);
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
    const std::optional<Frustum>& body = bodies_[indexOf(id)];
    if (!body) return false;
    const double apart = run.box.exteriorDistance(body->centerBox());
    const double widest = std::max(body->fromRadius, body->toRadius);
    const double rounding = 1e-9 * (apart + widest);
    return apart <= run.farthestFromAxis + rounding ||
           apart - widest <= run.farthestFromSurface + rounding;
  });
}

} // namespace espalier
