#include "core/decide/end_evidence.h"

#include "core/base/parallel.h"
#include "core/skeleton/assign_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint32_t ofNoEnd = std::numeric_limits<std::uint32_t>::max();
constexpr int bearerReach = 3; // edges below and above the foot

Eigen::AlignedBox3d boxOf(const Skeleton& skeleton, const BranchEnd& end) {
  Eigen::AlignedBox3d box(skeleton[end.foot].position);
  for (const NodeId id : end.nodes)
    box.extend(skeleton[id].position);
  return box;
}

Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double by) {
  return {box.min().array() - by, box.max().array() + by};
}

/// Cosine between the chord of an end and that of the wood below its foot; 0 at a root.
double turnOf(const Skeleton& skeleton, const BranchEnd& end) {
  NodeId below = end.foot;
  for (int i = 0; i < bearerReach && skeleton[below].parent; ++i)
    below = *skeleton[below].parent;
  const Eigen::Vector3d foot = skeleton[end.foot].position;
  const Eigen::Vector3d up = skeleton[end.nodes.front()].position - foot;
  const Eigen::Vector3d from = foot - skeleton[below].position;
  const double lengths = up.norm() * from.norm();
  return lengths > 0 ? up.dot(from) / lengths : 0;
}

bool isSame(const BranchEnd& a, const BranchEnd& b) {
  return a.foot == b.foot && a.nodes.size() == b.nodes.size(); // where their tips are the same
}

double lowerMedian(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

AllEnds allOf(const std::vector<EndsOfSkeleton::End>& ends, const PlantScale& scale) {
  AllEnds all{.count = static_cast<double>(ends.size()),
              .thickness = scale.thickness / scale.spacing,
              .noise = scale.scatter / scale.spacing};
  std::vector<double> scatter;
  double squares = 0;
  for (const auto& [end, evidence, seen] : ends) {
    scatter.push_back(evidence.scatter);
    all.standing += standingOf(evidence) / all.count;
    const double alone = shareAlone(evidence);
    all.alone += alone / all.count;
    squares += alone * alone / all.count;
  }
  all.scatter = lowerMedian(std::move(scatter));
  all.aloneSpread = std::sqrt(std::max(0.0, squares - all.alone * all.alone));
  return all;
}

} // namespace

// What is added keeps the logarithm of nothing finite.
double standingOf(const EndEvidence& evidence) {
  return std::log((evidence.protrusion + 0.1) / (evidence.length + 0.1));
}

double shareAlone(const EndEvidence& evidence) {
  return (evidence.alone + 0.5) / (evidence.points + 1);
}

EndsOfSkeleton::EndsOfSkeleton(Skeleton skeleton, const Eigen::Matrix3Xf& points,
                               const Eigen::Vector3d& origin, const PlantScale& scale,
                               const Progress& progress)
    : skeleton_(std::move(skeleton)), points_(&points), origin_(origin), scale_(scale),
      index_(skeleton_) {
  shareOut(progress.part(0, 0.5));
  list();
  std::vector<std::size_t> all(ends_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  look(all, progress.part(0.5, 1));
  keepAll();
}

/// What the ends there are now are like.
void EndsOfSkeleton::keepAll() {
  if (ends_.empty()) return;
  all_ = allOf(ends_, scale_);
  for (End& end : ends_)
    end.evidence.all = all_;
}

/// Gives each point to the node whose edge is nearest.
void EndsOfSkeleton::shareOut(const Progress& progress) {
  const std::vector<PointOnSkeleton> assigned =
      assignPoints(*points_, origin_, skeleton_, progress);
  begins_.assign(skeleton_.idEnd() + 1, 0);
  distances_.resize(assigned.size());
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    ++begins_[indexOf(assigned[i].child) + 1];
    distances_[i] = static_cast<float>(assigned[i].distance);
  }
  for (std::size_t i = 1; i < begins_.size(); ++i)
    begins_[i] += begins_[i - 1];
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  order_.resize(assigned.size());
  for (std::size_t i = 0; i < assigned.size(); ++i)
    order_[next[indexOf(assigned[i].child)]++] = static_cast<std::uint32_t>(i);
}

/// The ends there are now, without evidence.
void EndsOfSkeleton::list() {
  ends_.clear();
  endOf_.assign(skeleton_.idEnd(), ofNoEnd);
  for (BranchEnd& end : branchEnds(skeleton_)) {
    for (const NodeId id : end.nodes)
      endOf_[indexOf(id)] = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back({std::move(end), {}, {}});
  }
}

void EndsOfSkeleton::look(const std::vector<std::size_t>& places, const Progress& progress) {
  parallelFor(
      static_cast<Eigen::Index>(places.size()),
      [&](Eigen::Index i) {
        const std::size_t place = places[static_cast<std::size_t>(i)];
        ends_[place] = lookedAt(place);
      },
      progress, 1);
}

std::span<const std::uint32_t> EndsOfSkeleton::pointsOf(NodeId id) const {
  const std::size_t i = indexOf(id);
  return std::span(order_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
}

Eigen::Vector3d EndsOfSkeleton::placeOf(std::uint32_t point) const {
  return points_->col(static_cast<Eigen::Index>(point)).cast<double>() + origin_;
}

/// From a place to the skeleton without an end.
double EndsOfSkeleton::toRest(const Eigen::Vector3d& place, std::size_t end) const {
  return index_.distance(
      place, [&](NodeId id) { return skeleton_.contains(id) && endOf_[indexOf(id)] != end; });
}

/// The nodes near the foot whose edges bear an end: below it, and of what goes on above.
std::vector<NodeId> EndsOfSkeleton::bearerOf(std::size_t place) const {
  std::vector<NodeId> nodes;
  const NodeId foot = ends_[place].end.foot;
  NodeId at = foot;
  for (int i = 0; i < bearerReach && skeleton_[at].parent; ++i) {
    nodes.push_back(at);
    at = *skeleton_[at].parent;
  }
  for (NodeId child : skeleton_.children(foot)) {
    if (endOf_[indexOf(child)] == place) continue;
    for (int i = 0; i < bearerReach; ++i) {
      nodes.push_back(child);
      if (skeleton_.children(child).empty()) break;
      child = skeleton_.children(child).front();
    }
  }
  return nodes;
}

EndsOfSkeleton::End EndsOfSkeleton::lookedAt(std::size_t place) const {
  End found{ends_[place].end, {}, {}};
  const BranchEnd& end = found.end;
  EndEvidence& evidence = found.evidence;
  found.seen = boxOf(skeleton_, end);
  double bearing = 0, bearingPoints = 0;
  for (const NodeId id : bearerOf(place)) {
    found.seen.extend(skeleton_[id].position);
    for (const std::uint32_t point : pointsOf(id))
      bearing += distances_[point];
    bearingPoints += static_cast<double>(pointsOf(id).size());
  }
  const double bearer = bearingPoints > 0 ? bearing / bearingPoints : 0;
  const double explained = 2 * bearer + scale_.spacing;
  double scatter = 0;
  for (const NodeId id : end.nodes)
    for (const std::uint32_t point : pointsOf(id)) {
      const Eigen::Vector3d at = placeOf(point);
      found.seen.extend(at);
      scatter += distances_[point];
      ++evidence.points;
      if (toRest(at, place) > explained) ++evidence.alone;
    }
  const double protrusion = toRest(skeleton_[end.nodes.front()].position, place);
  found.seen = widened(found.seen, std::max(protrusion, explained));
  evidence.length = end.length / scale_.spacing;
  evidence.protrusion = protrusion / scale_.spacing;
  evidence.bearer = bearer / scale_.spacing;
  evidence.scatter = evidence.points > 0 ? scatter / evidence.points / scale_.spacing : 0;
  evidence.turn = turnOf(skeleton_, end);
  evidence.share = scale_.height > 0 ? end.length / scale_.height : 0;
  evidence.all = all_;
  return found;
}

void EndsOfSkeleton::remove(const std::vector<std::size_t>& gone, const Progress& progress) {
  std::vector<Eigen::AlignedBox3d> changed;
  for (const std::size_t place : gone) {
    changed.push_back(boxOf(skeleton_, ends_[place].end));
    for (const NodeId id : ends_[place].end.nodes)
      skeleton_.erase(id);
  }
  std::vector<const End*> known(skeleton_.idEnd(), nullptr);
  const std::vector<End> before = std::move(ends_);
  for (const End& end : before)
    known[indexOf(end.end.nodes.front())] = &end;
  list();
  std::vector<std::size_t> again;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const End* old = known[indexOf(ends_[i].end.nodes.front())];
    const bool isUnchanged =
        old && isSame(old->end, ends_[i].end) &&
        std::ranges::none_of(changed, [&](const auto& box) { return old->seen.intersects(box); });
    if (isUnchanged)
      ends_[i] = *old;
    else
      again.push_back(i);
  }
  look(again, progress);
}

} // namespace espalier
