#include "core/skeleton/review_stops.h"

#include "core/skeleton/length_along.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <utility>

namespace espalier {
namespace {

bool isReviewed(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].review.state == ReviewState::reviewed;
}

bool isToDo(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].review.state == ReviewState::toDo;
}

bool leadsTo(const Skeleton& skeleton, const ReviewStop& stop, WalkTo to) {
  const auto hasAny = [&](const auto& is) { return std::ranges::any_of(stop.nodes, is); };
  switch (to) {
  case WalkTo::anyStop:
    return true;
  case WalkTo::toDo:
    return (stop.isAtPoints() && !stop.isDoubtful) ||
           hasAny([&](NodeId id) { return isToDo(skeleton, id); });
  case WalkTo::notReviewed:
    return stop.isAtPoints() || hasAny([&](NodeId id) { return !isReviewed(skeleton, id); });
  case WalkTo::openEnd:
    return hasAny(
        [&](NodeId id) { return skeleton.children(id).empty() && !isReviewed(skeleton, id); });
  case WalkTo::branching:
    return hasAny(
        [&](NodeId id) { return skeleton.children(id).size() > 1 && !isReviewed(skeleton, id); });
  }
  return false;
}

/// Of how far points without wood reach from end to end, how much is missed wood: in simulated
/// scans, foliage included (espalier_fit_errors).
constexpr double missedOfCluster = 0.58;

/// Makes the stops of a plant along it.
class StopsOfPlant {
public:
  StopsOfPlant(const Skeleton& skeleton, const ExpectedErrors* errors)
      : skeleton_(skeleton), errors_(errors), longest_(longestStretch(skeleton)),
        axes_(axesInWalkOrder(skeleton)), whole_(skeleton.idEnd()), isTaken_(skeleton.idEnd()) {
    if (errors_ != nullptr) weigh();
  }

  [[nodiscard]] std::vector<ReviewStop> make() {
    for (const Axis& axis : axes_)
      if (!isTaken_[indexOf(axis.front())]) walkAlong(axis);
    for (ReviewStop& stop : stops_)
      rate(stop);
    if (errors_ != nullptr) addClusters();
    return std::move(stops_);
  }

private:
  /// What a node carries, it included.
  struct Whole {
    double length = 0; // [L] of its edges
    bool isClean = true;
  };
  using Part = std::pair<Axis, bool>; // and whether it is clean
  /// What one stop is to have.
  struct Wood {
    std::vector<NodeId> nodes = {};
    bool isClean = false;
    double length = 0;            // [L] of its edges
    Eigen::AlignedBox3d box = {}; // about these
  };

  /// Points without wood that are looked at together.
  struct Group {
    std::size_t behind; // which stop
    std::vector<std::size_t> clusters;
    Eigen::AlignedBox3d box; // about these
  };

  [[nodiscard]] double probability(NodeId id) const {
    if (!skeleton_[id].parent) return 0;
    return indexOf(id) < errors_->ofEdges.size() ? errors_->ofEdges[indexOf(id)] : 1;
  }
  [[nodiscard]] bool isClean(NodeId id) const { return probability(id) < riskyFrom; }
  [[nodiscard]] double lengthOf(const std::vector<NodeId>& nodes) const {
    double length = 0;
    for (const NodeId id : nodes)
      length += edgeLength(skeleton_, id);
    return length;
  }

  void weigh() {
    const std::vector<NodeId> ids = skeleton_.ids();
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
      Whole& whole = whole_[indexOf(*id)];
      whole.length += edgeLength(skeleton_, *id);
      whole.isClean = whole.isClean && isClean(*id);
      if (const auto parent = skeleton_[*id].parent) {
        whole_[indexOf(*parent)].length += whole.length;
        whole_[indexOf(*parent)].isClean = whole_[indexOf(*parent)].isClean && whole.isClean;
      }
    }
  }

  void walkAlong(const Axis& axis) {
    if (errors_ == nullptr) {
      for (Stretch& stretch : stretchesAlong(skeleton_, axis, longest_))
        stops_.push_back({.nodes = std::move(stretch), .clusters = {}});
      return;
    }
    for (const auto& [part, isClean] : partsOf(axis))
      take(part, isClean);
    takeBranches(axis);
    for (Wood& wood : std::exchange(open_, {}))
      stops_.push_back({.nodes = std::move(wood.nodes), .clusters = {}});
  }

  /// The clean and the risky parts of an axis in turn; a root goes with what follows.
  [[nodiscard]] std::vector<Part> partsOf(const Axis& axis) const {
    std::vector<Part> parts;
    for (const NodeId id : axis) {
      if (parts.empty() || parts.back().second != isClean(id)) parts.push_back({{}, isClean(id)});
      parts.back().first.push_back(id);
    }
    if (parts.size() > 1)
      for (auto& [part, isClean] : parts)
        if (isClean && lengthOf(part) < longest_ / 2) isClean = false;
    std::vector<Part> joined;
    for (auto& [part, isClean] : parts)
      if (!joined.empty() && joined.back().second == isClean)
        joined.back().first.insert(joined.back().first.end(), part.begin(), part.end());
      else
        joined.emplace_back(std::move(part), isClean);
    return joined;
  }

  /// How much one stop holds of wood, and across [L].
  [[nodiscard]] double most(bool isClean) const { return (isClean ? longestLook : 1) * longest_; }

  /// In as many stops as it needs to be seen well. What is clean is as long as it likes, but for
  /// that.
  void take(const Axis& part, bool isClean) {
    open_.push_back({.isClean = isClean});
    for (const NodeId id : part) {
      Wood edge{.nodes = {id}, .isClean = isClean, .length = edgeLength(skeleton_, id)};
      extend(edge.box, id);
      const Wood& last = open_.back();
      const bool isLong = !isClean && last.length + edge.length > most(false);
      if (last.length > 0 && (isLong || isWide(last, edge))) // a root alone is nothing to look at
        open_.push_back({.isClean = isClean});
      add(std::move(edge), open_.back());
    }
  }

  /// Puts each branch that is small enough into the first stop that it fits.
  void takeBranches(const Axis& bearers) {
    for (const NodeId bearer : bearers)
      for (const NodeId branch : skeleton_.children(bearer)) {
        const Whole& whole = whole_[indexOf(branch)];
        if (nextOnAxis(skeleton_, bearer) == branch || whole.length > most(whole.isClean)) continue;
        Wood wood{
            .nodes = withAllCarried(branch), .isClean = whole.isClean, .length = whole.length};
        for (const NodeId id : wood.nodes) {
          extend(wood.box, id);
          isTaken_[indexOf(id)] = true;
        }
        const auto fits = [&](const Wood& into) {
          return into.isClean == wood.isClean && into.length + wood.length <= most(wood.isClean) &&
                 !isWide(into, wood);
        };
        const auto into = std::ranges::find_if(open_, fits);
        if (into != open_.end())
          add(std::move(wood), *into);
        else
          open_.push_back(std::move(wood));
      }
  }

  [[nodiscard]] bool isWide(const Wood& wood, const Wood& more) const { // together
    return wood.box.merged(more.box).diagonal().norm() > most(wood.isClean);
  }

  static void add(Wood more, Wood& to) {
    to.nodes.insert(to.nodes.end(), more.nodes.begin(), more.nodes.end());
    to.length += more.length;
    to.box.extend(more.box);
  }

  void extend(Eigen::AlignedBox3d& box, NodeId id) const {
    box.extend(skeleton_[id].position);
    if (const auto parent = skeleton_[id].parent) box.extend(skeleton_[*parent].position);
  }

  [[nodiscard]] std::vector<NodeId> withAllCarried(NodeId id) const {
    std::vector<NodeId> nodes = {id};
    for (std::size_t next = 0; next < nodes.size(); ++next)
      nodes.insert(nodes.end(), skeleton_.children(nodes[next]).begin(),
                   skeleton_.children(nodes[next]).end());
    return nodes;
  }

  void rate(ReviewStop& stop) const {
    stop.length = lengthOf(stop.nodes);
    if (errors_ == nullptr) return;
    stop.isClean = std::ranges::all_of(stop.nodes, [&](NodeId id) { return isClean(id); });
    for (const NodeId id : stop.nodes)
      stop.wrong += probability(id) * edgeLength(skeleton_, id);
  }

  /// Points without wood in walk order: each cluster with the first that both fit one stretch with.
  /// Few points are left to the findings.
  void addClusters() {
    std::vector<std::vector<std::size_t>> near(skeleton_.idEnd()); // clusters, by node
    for (std::size_t i = 0; i < errors_->clusters.size(); ++i)
      if (skeleton_.contains(errors_->clusters[i].node))
        near[indexOf(errors_->clusters[i].node)].push_back(i);
    std::vector<Group> groups;
    for (std::size_t stop = 0; stop < stops_.size(); ++stop)
      for (const NodeId id : stops_[stop].nodes)
        for (const std::size_t i : near[indexOf(id)])
          addTo(groups, {stop, {i}, boxOf(errors_->clusters[i])});
    std::vector<ReviewStop> all;
    auto group = groups.begin(); // by stop
    for (std::size_t stop = 0; stop < stops_.size(); ++stop) {
      all.push_back(std::move(stops_[stop]));
      for (; group != groups.end() && group->behind == stop; ++group)
        if (ReviewStop points = stopOfPoints(std::move(group->clusters));
            points.wrong >= riskyFrom * longest_) // as much as in a stretch that is not clean
          all.push_back(std::move(points));
    }
    stops_ = std::move(all);
  }

  static Eigen::AlignedBox3d boxOf(const Finding& cluster) {
    return {cluster.place.array() - cluster.reach, cluster.place.array() + cluster.reach};
  }

  void addTo(std::vector<Group>& groups, Group one) const {
    const auto into = std::ranges::find_if(groups, [&](const Group& group) {
      return group.box.merged(one.box).diagonal().norm() <= longest_;
    });
    if (into == groups.end()) return groups.push_back(std::move(one));
    into->clusters.insert(into->clusters.end(), one.clusters.begin(), one.clusters.end());
    into->box.extend(one.box);
  }

  [[nodiscard]] ReviewStop stopOfPoints(std::vector<std::size_t> clusters) const {
    ReviewStop stop{.nodes = {}, .clusters = std::move(clusters)};
    for (const std::size_t i : stop.clusters)
      stop.wrong += missedOfCluster * 2 * errors_->clusters[i].reach;
    return stop;
  }

  const Skeleton& skeleton_;
  const ExpectedErrors* errors_;
  double longest_; // stretch [L]
  std::vector<Axis> axes_;
  std::vector<Whole> whole_;  // by id
  std::vector<bool> isTaken_; // by id: in a stop with what bears it
  std::vector<Wood> open_;    // of the axis that is walked along
  std::vector<ReviewStop> stops_;
};

} // namespace

std::vector<ReviewStop> reviewStops(const Skeleton& skeleton, const ExpectedErrors* errors,
                                    WalkOrder order) {
  std::vector<ReviewStop> stops = StopsOfPlant(skeleton, errors).make();
  if (order == WalkOrder::byExpectedError)
    std::ranges::stable_sort(stops, std::greater<>(), &ReviewStop::wrong);
  return stops;
}

std::optional<std::size_t> stopOf(const std::vector<ReviewStop>& stops, NodeId id) {
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (std::ranges::find(stops[i].nodes, id) != stops[i].nodes.end()) return i;
  return std::nullopt;
}

std::optional<std::size_t> walk(const Skeleton& skeleton, const std::vector<ReviewStop>& stops,
                                std::optional<std::size_t> from, WalkTo to,
                                WalkDirection direction) {
  const std::size_t count = stops.size();
  const bool isForward = direction == WalkDirection::forward;
  std::size_t at = from.value_or(isForward ? count - 1 : 0);
  for (std::size_t tried = 0; tried < count; ++tried) {
    at = (at + (isForward ? 1 : count - 1)) % count;
    if (leadsTo(skeleton, stops[at], to)) return at;
  }
  return std::nullopt;
}

} // namespace espalier
