#include "core/pipeline/attach_grown.h"

#include "core/base/paced_check.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The points of a scan, asked from places of the file.
class Points {
public:
  Points(const PointCloud& cloud, double spacing, const Progress& progress)
      : cloud_(cloud), index_(cloud.positions(), progress), spacing_(spacing), check_(progress) {}

  /// @throws Cancelled
  [[nodiscard]] Vector3d nearest(const Vector3d& place) {
    check_.after(ofQuery);
    return cloud_.position(index_.nearest((place - cloud_.origin()).cast<float>(), 1)[0].index);
  }

  /// Whether no stretch of the line between two nodes that is longer than `widest` [L] lies farther
  /// from all points than their wood reaches. @throws Cancelled
  [[nodiscard]] bool hasNoGap(const Node& from, const Node& to, double widest) {
    const double length = (to.position - from.position).norm();
    const double steps = std::clamp(std::ceil(2 * length / spacing_), 1.0, 10'000.0);
    const auto places = static_cast<int>(steps) + 1;
    int tooMany = 0; // places in a row that make a gap
    for (double gap = 0; gap <= widest && tooMany <= places; ++tooMany)
      gap += length / steps;
    // Looks at the end of each such row first, and passes over what lies before a place near points
    // (Boyer and Moore's search, CACM 20(10), 1977).
    int first = 0; // of the row
    int known = 0; // from first to before it, all are off the points
    while (first + tooMany <= places) {
      const int end = first + tooMany;
      int at = end;
      while (at > known && !isNear(from, to, (at - 1) / steps))
        --at;
      if (at == known) return false;
      first = at;
      known = end;
    }
    return true;
  }

private:
  static constexpr std::size_t ofQuery = 256; // steps of PacedCheck: a query takes up to 1 us

  [[nodiscard]] bool isNear(const Node& from, const Node& to, double share) {
    constexpr double reach = 2; // spacings beside the wood
    check_.after(ofQuery);
    const Vector3d place = from.position + share * (to.position - from.position);
    const double wood = from.radius + share * (to.radius - from.radius);
    return index_
        .nearestOne((place - cloud_.origin()).cast<float>(),
                    static_cast<float>(wood + reach * spacing_))
        .has_value();
  }

  const PointCloud& cloud_;
  SpatialIndex index_;
  double spacing_;
  PacedCheck check_;
};

/// Attachments across more than so many times the widest join are not tried, though points may lie
/// all along them: nothing grew there. Those that were made of grown shrubs and the walnut branch
/// of the tests reach 4 times it.
constexpr double longestAttachment = 10;

double cosine(const Vector3d& a, const Vector3d& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0 ? a.dot(b) / lengths : 1;
}

/// A node of what grew; its links lead in both directions until it is attached.
struct Loose {
  Node node; // without parent
  std::vector<std::uint32_t> links;
  std::uint32_t piece = none; // none: it has its place, or is left out
};

/// What new wood may be attached to.
struct Bearer {
  Node node;          // its position and radius
  Vector3d direction; // in which it grew [L]; 0: a root
  NodeId on;          // of the plant, and where on its edge
  double fraction = 1;
  std::uint32_t loose = none; // the new node that it is; none: of the plant
};

/// How a piece may be attached.
struct Entry {
  double cost = infinity;
  std::uint32_t at = none; // the node that it is entered at
  Bearer bearer = {};
};

class Attaching {
public:
  Attaching(const Skeleton& plant, const std::vector<NodeId>& onto, const Skeleton& grown,
            const PointCloud& cloud, const AttachOptions& options, const Progress& progress)
      : plant_(plant), options_(options), points_(cloud, options.spacing, progress),
        progress_(progress), check_(progress), leastCosine_(std::cos(options.sharpestTurn)),
        short_(meanEdgeLength(grown) / 3), mayBear_(plant.idEnd(), false),
        places_(3, static_cast<Eigen::Index>(onto.size())), onto_(onto),
        origin_(plant[onto.front()].position) {
    for (std::size_t i = 0; i < onto.size(); ++i) {
      mayBear_[indexOf(onto[i])] = true;
      places_.col(static_cast<Eigen::Index>(i)) = (plant[onto[i]].position - origin_).cast<float>();
    }
    take(grown);
  }

  std::vector<GrownBranch> run() {
    const SpatialIndex index(places_, progress_);
    ofPlant_ = &index;
    for (std::uint32_t i = 0; i < loose_.size(); ++i)
      if (loose_[i].piece == none) addPiece(i);
    while (true) {
      progress_.check();
      const auto next = std::ranges::min_element(best_, {}, &Entry::cost);
      if (next == best_.end() || next->cost == infinity) break;
      attach(static_cast<std::uint32_t>(next - best_.begin()));
    }
    return result();
  }

private:
  void take(const Skeleton& grown) {
    std::vector<std::uint32_t> copies(grown.idEnd(), none);
    for (const NodeId id : grown.ids()) {
      const Node& node = grown[id];
      copies[indexOf(id)] = static_cast<std::uint32_t>(loose_.size());
      loose_.push_back({.node = {.position = node.position, .radius = node.radius}, .links = {}});
      if (!node.parent) continue;
      const std::uint32_t from = copies[indexOf(*node.parent)];
      if (points_.hasNoGap(loose_[from].node, loose_.back().node, options_.widestGap))
        link(from, copies[indexOf(id)]);
    }
    parents_.resize(loose_.size());
  }

  /// A node as it will be on a bearer: no thicker than that, and within 1.5 spacings of the points,
  /// or half a spacing farther than its wood is thick. One that lies farther off, as in the air
  /// between two twigs, goes back to them.
  [[nodiscard]] Node onPoints(const Node& node, const Node& bearer) {
    Node result = node;
    if (bearer.radius > 0) result.radius = std::min(node.radius, bearer.radius);
    const Vector3d nearest = points_.nearest(node.position);
    const Vector3d off = node.position - nearest;
    const double most = std::max(1.5 * options_.spacing, result.radius + 0.5 * options_.spacing);
    const double usual = std::max(options_.spacing, result.radius);
    if (off.norm() > most) result.position = nearest + usual / off.norm() * off;
    return result;
  }

  void link(std::uint32_t a, std::uint32_t b) {
    loose_[a].links.push_back(b);
    loose_[b].links.push_back(a);
  }

  void unlink(std::uint32_t a, std::uint32_t b) {
    std::erase(loose_[a].links, b);
    std::erase(loose_[b].links, a);
  }

  /// The piece that a node is of, with what of the plant and of new wood it may be attached to.
  void addPiece(std::uint32_t first) {
    const auto piece = static_cast<std::uint32_t>(pieces_.size());
    std::vector<std::uint32_t> nodes = {first};
    loose_[first].piece = piece;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const std::uint32_t next : loose_[nodes[i]].links)
        if (loose_[next].piece != piece) {
          loose_[next].piece = piece;
          nodes.push_back(next);
        }
    pieces_.push_back(nodes);
    best_.emplace_back();
    for (const std::uint32_t node : nodes) {
      for (const Bearer& bearer : bearersNear(loose_[node].node.position))
        consider(piece, node, bearer);
      for (const Bearer& bearer : bearing_)
        consider(piece, node, bearer);
    }
  }

  /// Nodes of the plant near a place, and places on their edges.
  [[nodiscard]] std::vector<Bearer> bearersNear(const Vector3d& place) {
    constexpr int tried = 24;
    check_.after(tried * ofTry);
    std::vector<Bearer> bearers;
    std::vector<NodeId> edges;
    for (const Neighbor& near : ofPlant_->nearest((place - origin_).cast<float>(), tried)) {
      const NodeId id = onto_[static_cast<std::size_t>(near.index)];
      bearers.push_back(bearerAt(id));
      edges.push_back(id);
      for (const NodeId child : plant_.children(id))
        if (mayBear_[indexOf(child)]) edges.push_back(child);
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const NodeId id : edges)
      if (auto bearer = bearerOnEdge(id, place)) bearers.push_back(std::move(*bearer));
    return bearers;
  }

  [[nodiscard]] Bearer bearerAt(NodeId id) const {
    const Node& node = plant_[id];
    Vector3d direction = Vector3d::Zero();
    if (node.parent) direction = node.position - plant_[*node.parent].position;
    return {.node = {.position = node.position, .radius = node.radius},
            .direction = direction,
            .on = id};
  }

  /// The place of an edge that is nearest, where that is far from both its ends.
  [[nodiscard]] std::optional<Bearer> bearerOnEdge(NodeId id, const Vector3d& place) const {
    constexpr double nearNode = 0.3; // of the edge, as branches slide along axes
    constexpr double farthest = 6;   // spacings, on long edges
    const Node& node = plant_[id];
    if (!node.parent || !mayBear_[indexOf(*node.parent)]) return std::nullopt;
    const Node& below = plant_[*node.parent];
    const Vector3d along = node.position - below.position;
    const double length = along.norm();
    const double near = std::min(nearNode * length, farthest * options_.spacing);
    if (near < 2 * options_.spacing) return std::nullopt;
    const double fraction = (place - below.position).dot(along) / (length * length);
    if (std::min(fraction, 1 - fraction) * length < near) return std::nullopt;
    return Bearer{.node = {.position = below.position + fraction * along,
                           .radius = below.radius + fraction * (node.radius - below.radius)},
                  .direction = along,
                  .on = id,
                  .fraction = fraction};
  }

  [[nodiscard]] Bearer bearerOf(std::uint32_t loose) const {
    return {.node = loose_[loose].node,
            .direction = loose_[loose].node.position - parents_[loose].node.position,
            .on = parents_[loose].on,
            .fraction = parents_[loose].fraction,
            .loose = loose};
  }

  void consider(std::uint32_t piece, std::uint32_t at, const Bearer& bearer) {
    check_.after(ofTry);
    const Node& node = loose_[at].node;
    const Vector3d link = node.position - bearer.node.position;
    const double gap = std::max(0.0, link.norm() - bearer.node.radius - node.radius);
    if (gap > longestAttachment * options_.widestJoin) return;
    constexpr double atOnce = 3; // spacings that any attachment costs: short ones may turn as well
    const double least = gap + atOnce * options_.spacing;
    if (least >= best_[piece].cost) return;
    const double cost = least * (1 + turnCost(at, bearer, link));
    if (cost >= best_[piece].cost) return;
    const bool isFar = gap > options_.widestJoin;
    if (isFar && !(gap <= options_.widestAhead && isAhead(at, link)) &&
        !points_.hasNoGap(bearer.node, node, options_.widestJoin))
      return;
    best_[piece] = {cost, at, bearer};
  }

  /// Whether the end of a piece leads back along a link, over a few of its nodes.
  [[nodiscard]] bool isAhead(std::uint32_t at, const Vector3d& link) const {
    constexpr double least = 0.77; // cosine of 40 degrees
    constexpr int behind = 3;      // nodes
    if (loose_[at].links.size() != 1) return false;
    std::uint32_t before = at;
    std::uint32_t end = loose_[at].links.front();
    for (int i = 1; i < behind && loose_[end].links.size() == 2; ++i) {
      const std::uint32_t next = loose_[end].links[loose_[end].links[0] == before ? 1 : 0];
      before = end;
      end = next;
    }
    return cosine(link, loose_[end].node.position - loose_[at].node.position) >= least;
  }

  /// How much more an attachment costs that turns; infinite where it turns too sharply.
  [[nodiscard]] double turnCost(std::uint32_t at, const Bearer& bearer,
                                const Vector3d& link) const {
    constexpr double weight = 4; // as across gaps in the reconstruction (GapOptions)
    const double below = bearer.direction.isZero(0) ? 1 : cosine(bearer.direction, link);
    if (below < leastCosine_) return infinity;
    double sharpest = 1;
    bool goesOn = loose_[at].links.empty();
    for (const std::uint32_t next : loose_[at].links) {
      const double on = cosine(link, loose_[next].node.position - loose_[at].node.position);
      sharpest = std::min(sharpest, on);
      goesOn = goesOn || on >= leastCosine_;
    }
    return goesOn ? weight * ((1 - below) / 2 + (1 - sharpest) / 2) : infinity;
  }

  void attach(std::uint32_t piece) {
    const Entry entry = std::exchange(best_[piece], {});
    for (const std::uint32_t node : pieces_[piece])
      loose_[node].piece = none;
    std::vector<std::uint32_t> added;
    std::vector<std::uint32_t> cut; // where pieces of their own begin
    place(entry.at, entry.bearer, added, cut);
    const std::size_t before = bearing_.size();
    for (const std::uint32_t node : added) {
      attached_.push_back(node);
      bearing_.push_back(bearerOf(node));
    }
    for (const std::uint32_t first : cut)
      if (loose_[first].piece == none && !loose_[first].links.empty()) addPiece(first);
    for (std::uint32_t other = 0; other < best_.size(); ++other)
      if (isWaiting(other))
        for (const std::uint32_t at : pieces_[other])
          for (std::size_t i = before; i < bearing_.size(); ++i)
            consider(other, at, bearing_[i]);
  }

  [[nodiscard]] bool isWaiting(std::uint32_t piece) const {
    return loose_[pieces_[piece].front()].piece == piece;
  }

  /// Gives a node its place, and all that goes on from it without a sharp turn.
  void place(std::uint32_t first, const Bearer& on, std::vector<std::uint32_t>& added,
             std::vector<std::uint32_t>& cut) {
    std::vector<std::pair<std::uint32_t, Bearer>> open = {{first, on}};
    while (!open.empty()) {
      const auto [at, bearer] = open.back();
      open.pop_back();
      Node node = onPoints(loose_[at].node, bearer.node);
      // It was found to go on where it was: were it cut now, it would be tried for ever.
      if (!goesOn(bearer, node.position)) node.position = loose_[at].node.position;
      const bool isPassed =
          mayBePassed(at, bearer); // it only makes the branch turn, or adds nothing
      if (!isPassed && !goesOn(bearer, node.position)) {
        cut.push_back(at);
        continue;
      }
      if (!isPassed) {
        loose_[at].node = node;
        parents_[at] = bearer;
        added.push_back(at);
      }
      const Bearer next = isPassed ? bearer : bearerOf(at);
      for (const std::uint32_t beyond : std::vector(loose_[at].links)) {
        unlink(at, beyond);
        open.emplace_back(beyond, next);
      }
    }
  }

  /// Does a branch on from a bearer turn off no more than it may?
  [[nodiscard]] bool goesOn(const Bearer& bearer, const Vector3d& to) const {
    return bearer.direction.isZero(0) ||
           cosine(bearer.direction, to - bearer.node.position) >= leastCosine_;
  }

  /// Does the branch from a bearer lead on without this node, where it does not with it, or would
  /// not need it?
  [[nodiscard]] bool mayBePassed(std::uint32_t at, const Bearer& bearer) {
    const std::vector<std::uint32_t>& links = loose_[at].links;
    const Vector3d place = loose_[at].node.position;
    const Vector3d link = place - bearer.node.position;
    const auto turnsSharply = [&](std::uint32_t next) {
      return cosine(link, loose_[next].node.position - place) < leastCosine_;
    };
    const bool isShort = link.norm() <= short_;
    const bool isKink = links.size() == 1 && (!goesOn(bearer, place) || turnsSharply(links[0]));
    if (links.empty() || !(isShort || isKink)) return false;
    const double widest = std::max(options_.widestGap, options_.widestJoin);
    return std::ranges::all_of(links, [&](std::uint32_t next) {
      return goesOn(bearer, loose_[next].node.position) &&
             points_.hasNoGap(bearer.node, loose_[next].node, widest);
    });
  }

  [[nodiscard]] std::vector<GrownBranch> result() const {
    std::map<std::pair<NodeId, double>, Skeleton> trees; // by place
    std::vector<NodeId> copies(loose_.size());
    for (const std::uint32_t i : attached_) { // each after its bearer
      const Bearer& bearer = parents_[i];
      Skeleton& tree = trees[{bearer.on, bearer.fraction}];
      if (tree.isEmpty()) (void)tree.add(bearer.node); // the plant's: it came first
      const NodeId parent = bearer.loose == none ? tree.roots().front() : copies[bearer.loose];
      Node node = loose_[i].node;
      node.parent = parent;
      copies[i] = tree.add(node);
    }
    std::vector<GrownBranch> branches;
    branches.reserve(trees.size());
    for (auto& [place, tree] : trees)
      branches.push_back({place.first, withAssembledAxes(tree), place.second});
    return branches;
  }

  static constexpr std::size_t ofTry = 32; // steps of PacedCheck

  const Skeleton& plant_;
  AttachOptions options_;
  Points points_;
  const Progress& progress_;
  PacedCheck check_;
  double leastCosine_;
  double short_; // [L]: a node nearer to its bearer than this stands for the same place
  std::vector<bool> mayBear_; // by id
  Eigen::Matrix3Xf places_;   // of onto_, about origin_
  std::vector<NodeId> onto_;
  Vector3d origin_;
  const SpatialIndex* ofPlant_ = nullptr; // of places_
  std::vector<Loose> loose_;
  std::vector<Bearer> parents_; // of the attached
  std::vector<std::uint32_t> attached_;
  std::vector<Bearer> bearing_;                    // those, as what others are attached to
  std::vector<std::vector<std::uint32_t>> pieces_; // nodes, as they were found
  std::vector<Entry> best_;                        // by piece
};

} // namespace

std::vector<GrownBranch> attached(const Skeleton& plant, const std::vector<NodeId>& onto,
                                  const Skeleton& grown, const PointCloud& cloud,
                                  const AttachOptions& options, const Progress& progress) {
  assert(!onto.empty() && options.spacing > 0 && options.widestGap > 0 && options.widestJoin > 0);
  return Attaching(plant, onto, grown, cloud, options, progress).run();
}

std::vector<std::vector<NodeId>> addGrown(SkeletonEditor& editor,
                                          const std::vector<GrownBranch>& branches) {
  std::vector<std::size_t> downward(branches.size());
  std::iota(downward.begin(), downward.end(), std::size_t{0});
  std::ranges::stable_sort(downward, std::greater<>(),
                           [&](std::size_t i) { return branches[i].fraction; });
  std::map<NodeId, std::pair<NodeId, double>> left; // of an edge: its upper node, and where that is
  std::vector<std::vector<NodeId>> first(branches.size());
  for (const std::size_t i : downward) {
    const GrownBranch& branch = branches[i];
    NodeId on = branch.on;
    if (branch.fraction < 1) {
      const auto [upper, at] = left.try_emplace(on, on, 1.0).first->second;
      on = splitEdge(editor, upper, branch.fraction / at);
      left[branch.on] = {on, branch.fraction};
    }
    first[i] = addCarried(editor, on, branch.part);
  }
  return first;
}

} // namespace espalier
