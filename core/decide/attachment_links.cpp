#include "core/decide/attachment_links.h"

#include "core/base/parallel.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double aheadReach = 30; // spacings, to ends that the wood may go on from
constexpr double besideReach = 8; // spacings between surfaces, to other places
constexpr double lookAlong = 12;  // spacings of wood that say where it goes
constexpr double longEdge = 4;    // spacings between the surfaces at its ends: one may be a gap
constexpr std::size_t mostLinks = 6;

/// Finds what wood may be attached to.
class AttachmentSearch {
public:
  AttachmentSearch(const Skeleton& skeleton, const SpatialIndex& points, Vector3d origin,
                   double spacing, Vector3d up)
      : skeleton_(skeleton), points_(points), origin_(std::move(origin)), spacing_(spacing),
        up_(std::move(up)), ids_(skeleton.ids()), carried_(carriedLengths(skeleton)),
        first_(skeleton.idEnd()), last_(skeleton.idEnd()), run_(skeleton.idEnd()),
        runLength_(skeleton.idEnd()), places_(3, static_cast<Eigen::Index>(ids_.size())),
        nodes_(placed()) {
    numberNodes();
    measureRuns();
  }

  [[nodiscard]] std::vector<AttachmentChoice> find(const Progress& progress) const {
    std::vector<NodeId> asked;
    for (const NodeId id : ids_)
      if (isAsked(id)) asked.push_back(id);
    std::vector<AttachmentChoice> choices(asked.size());
    const auto look = [&](Eigen::Index i) {
      choices[static_cast<std::size_t>(i)] = choiceOf(asked[static_cast<std::size_t>(i)]);
    };
    parallelFor(static_cast<Eigen::Index>(asked.size()), look, progress, 8);
    std::erase_if(choices, [](const AttachmentChoice& choice) { return choice.links.size() < 2; });
    return choices;
  }

private:
  const Eigen::Matrix3Xf& placed() {
    for (std::size_t i = 0; i < ids_.size(); ++i)
      places_.col(static_cast<Eigen::Index>(i)) =
          (skeleton_[ids_[i]].position - origin_).cast<float>();
    return places_;
  }

  /// In depth-first order, so that what a node carries is one run of numbers.
  void numberNodes() {
    std::vector<std::size_t> size(skeleton_.idEnd(), 1);
    for (auto id = ids_.rbegin(); id != ids_.rend(); ++id)
      if (const auto parent = skeleton_[*id].parent) size[indexOf(*parent)] += size[indexOf(*id)];
    std::vector<std::size_t> next(skeleton_.idEnd(), 0);
    std::size_t ofRoots = 0;
    for (const NodeId id : ids_) {
      const auto parent = skeleton_[id].parent;
      std::size_t& at = parent ? next[indexOf(*parent)] : ofRoots;
      first_[indexOf(id)] = at;
      at += size[indexOf(id)];
      last_[indexOf(id)] = at;
      next[indexOf(id)] = first_[indexOf(id)] + 1;
    }
  }

  /// Unbranched runs: which one each node is in, and the length of it up to there.
  void measureRuns() {
    for (const NodeId id : ids_) {
      const auto parent = skeleton_[id].parent;
      const bool goesOn = parent && skeleton_.children(*parent).size() == 1;
      run_[indexOf(id)] = goesOn ? run_[indexOf(*parent)] : id;
      runLength_[indexOf(id)] =
          edgeLength(skeleton_, id) + (goesOn ? runLength_[indexOf(*parent)] : 0);
    }
  }

  [[nodiscard]] double gapBetween(NodeId a, NodeId b) const { // spacings
    const double apart = (skeleton_[a].position - skeleton_[b].position).norm() -
                         skeleton_[a].radius - skeleton_[b].radius;
    return std::max(0.0, apart) / spacing_;
  }

  [[nodiscard]] bool isAsked(NodeId id) const {
    const auto parent = skeleton_[id].parent;
    return parent && (skeleton_.children(*parent).size() > 1 || gapBetween(*parent, id) > longEdge);
  }

  [[nodiscard]] bool carries(NodeId a, NodeId b) const {
    return first_[indexOf(b)] >= first_[indexOf(a)] && first_[indexOf(b)] < last_[indexOf(a)];
  }

  /// Where the wood above a node goes; 0 where it is a node alone.
  [[nodiscard]] Vector3d directionAbove(NodeId id) const {
    NodeId at = id;
    for (double length = 0; length < lookAlong * spacing_;) {
      const auto next = nextOnAxis(skeleton_, at);
      if (!next) break;
      at = *next;
      length += edgeLength(skeleton_, at);
    }
    return unit(skeleton_[at].position - skeleton_[id].position);
  }

  [[nodiscard]] Vector3d directionBelow(NodeId id) const {
    NodeId at = id;
    for (double length = 0; length < lookAlong * spacing_ && skeleton_[at].parent;) {
      length += edgeLength(skeleton_, at);
      at = *skeleton_[at].parent;
    }
    return unit(skeleton_[id].position - skeleton_[at].position);
  }

  [[nodiscard]] static Vector3d unit(const Vector3d& span) {
    const double length = span.norm();
    return length > 0 ? Vector3d(span / length) : Vector3d::Zero();
  }

  [[nodiscard]] AttachmentEvidence evidenceOf(NodeId from, NodeId to, const Vector3d& above) const {
    const Node& lower = skeleton_[from];
    const Node& upper = skeleton_[to];
    const Vector3d edge = upper.position - lower.position;
    const Vector3d below = directionBelow(from);
    AttachmentEvidence evidence{.gap = gapBetween(from, to),
                                .goesOn = above.dot(unit(edge)),
                                .turn = above.dot(below),
                                .upward = unit(edge).dot(up_),
                                .carried = (carried_[indexOf(to)]) / spacing_,
                                .isThere = upper.parent == from};
    evidence.miss = (edge - above * above.dot(edge)).norm() / spacing_;
    if (lower.radius > 0 && upper.radius > 0)
      evidence.thicker = std::log(upper.radius / lower.radius);
    bool isEnd = true;
    for (const NodeId child : skeleton_.children(from)) {
      if (child == to) continue;
      isEnd = false;
      evidence.sibling = std::max(evidence.sibling, below.dot(directionAbove(child)));
    }
    if (isEnd) evidence.end = runLength_[indexOf(from)] / spacing_;
    return evidence;
  }

  [[nodiscard]] double shareInAir(NodeId from, NodeId to) const {
    constexpr double nearReach = 2; // spacings from the surface
    constexpr double most = 60;     // steps
    const Node& lower = skeleton_[from];
    const Node& upper = skeleton_[to];
    const Vector3d edge = upper.position - lower.position;
    const double steps = std::clamp(std::ceil(edge.norm() / spacing_), 1.0, most);
    double inAir = 0;
    for (double step = 0.5; step < steps; ++step) {
      const double share = step / steps;
      const Vector3d place = lower.position + share * edge - origin_;
      const double radius = std::min(lower.radius, upper.radius);
      const double reach = radius + nearReach * spacing_;
      if (!points_.nearestOne(place.cast<float>(), static_cast<float>(reach))) ++inAir;
    }
    return inAir / steps;
  }

  /// How unlikely a place seems at first sight [spacings].
  [[nodiscard]] static double costOf(const AttachmentEvidence& evidence) {
    return evidence.gap + evidence.miss / 2 + 4 * (1 - evidence.goesOn) + 2 * (1 - evidence.turn) +
           10 * evidence.inAir;
  }

  [[nodiscard]] AttachmentChoice choiceOf(NodeId id) const {
    const NodeId parent = *skeleton_[id].parent;
    const Vector3d above = directionAbove(id);
    std::map<NodeId, std::pair<double, AttachmentLink>> best; // by the run that would bear it
    const auto note = [&](NodeId from) {
      if (carries(id, from) || from == parent) return;
      const NodeId run = run_[indexOf(from)];
      if (meets(run, parent)) return;
      const bool isEnd = skeleton_.children(from).empty();
      const double gap = gapBetween(from, id);
      if (gap > (isEnd ? aheadReach : besideReach)) return;
      const AttachmentLink link{from, evidenceOf(from, id, above)};
      const double cost = costOf(link.evidence);
      const auto [place, isNew] = best.try_emplace(run, cost, link);
      if (!isNew && cost < place->second.first) place->second = {cost, link};
    };
    const Eigen::Vector3f place = (skeleton_[id].position - origin_).cast<float>();
    std::vector<Neighbor> near =
        nodes_.within(place, static_cast<float>(aheadReach * spacing_ + skeleton_[parent].radius));
    std::ranges::sort(near, {}, &Neighbor::index);
    for (const Neighbor& neighbor : near)
      note(ids_[static_cast<std::size_t>(neighbor.index)]);
    AttachmentChoice choice{id, {{parent, evidenceOf(parent, id, above)}}};
    choice.links.front().evidence.inAir = shareInAir(parent, id);
    std::vector<std::pair<double, AttachmentLink>> others;
    others.reserve(best.size());
    for (const auto& [run, link] : best)
      others.push_back(link);
    keepCheapest(others, 2 * mostLinks);
    for (auto& [cost, link] : others) {
      link.evidence.inAir = shareInAir(link.from, id);
      cost = costOf(link.evidence);
    }
    keepCheapest(others, mostLinks - 1);
    choice.links.reserve(1 + others.size());
    for (const auto& [cost, link] : others)
      choice.links.push_back(link);
    return choice;
  }

  static void keepCheapest(std::vector<std::pair<double, AttachmentLink>>& links,
                           std::size_t count) {
    std::ranges::stable_sort(links, {}, [](const auto& link) { return link.first; });
    if (links.size() > count)
      links.erase(links.begin() + static_cast<std::ptrdiff_t>(count), links.end());
  }

  /// Does a run lead to a node, or begin at it? Then it is the wood that is there already.
  [[nodiscard]] bool meets(NodeId run, NodeId node) const {
    return run == run_[indexOf(node)] || skeleton_[run].parent == node;
  }

  const Skeleton& skeleton_;
  const SpatialIndex& points_;
  Vector3d origin_;
  double spacing_;
  Vector3d up_;
  std::vector<NodeId> ids_;
  std::vector<double> carried_;           // by id [L]
  std::vector<std::size_t> first_, last_; // by id
  std::vector<NodeId> run_;               // by id: the first node of its run
  std::vector<double> runLength_;         // by id [L]
  Eigen::Matrix3Xf places_;               // of ids_, about the origin
  SpatialIndex nodes_;
};

} // namespace

std::vector<AttachmentChoice> attachmentChoices(const Skeleton& skeleton, const SpatialIndex& index,
                                                const Eigen::Vector3d& origin, double spacing,
                                                const Eigen::Vector3d& up,
                                                const Progress& progress) {
  progress.check();
  if (skeleton.isEmpty()) return {};
  return AttachmentSearch(skeleton, index, origin, spacing, up).find(progress);
}

} // namespace espalier
