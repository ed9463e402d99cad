#include "tests/support/planted_errors.h"

#include "core/base/random.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/point_distances.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace espalier::test {
namespace {

using PlantedKind = PlantedError::Kind;

double turnBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

class Planter {
public:
  Planter(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud, double spacing,
          std::uint64_t seed)
      : clean_(skeleton), plant_(skeleton), cloud_(*cloud), spacing_(spacing), random_(seed),
        index_(cloud->positions()), distances_(cloud, spacing, skeleton), wood_(bodiesOf(skeleton)),
        isTaken_(skeleton.idEnd(), false), pointsOf_(skeleton.idEnd()) {
    for (Eigen::Index i = 0; i < cloud->size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (distances_.toSurface()[k] < 3 * spacing)
        pointsOf_[indexOf(distances_.nearest()[k])].push_back(i);
    }
  }

  void plant(PlantedKind kind, int count) {
    std::vector<NodeId> candidates = clean_.ids();
    for (std::size_t i = candidates.size(); i > 1; --i) // Fisher and Yates
      std::swap(candidates[i - 1], candidates[random_.below(i)]);
    int done = 0;
    for (const bool isSpecial : {true, false}) // of two forms, that of the first half
      for (const NodeId id : candidates) {
        if (done == (isSpecial ? count / 2 : count)) break;
        std::optional<PlantedError> error = tryAt(kind, id, isSpecial);
        if (!error) continue;
        std::ranges::sort(error->points);
        errors_.push_back(std::move(*error));
        ++done;
      }
  }

  [[nodiscard]] PlantedPlant result() && { return {std::move(plant_), std::move(errors_)}; }

private:
  std::optional<PlantedError> tryAt(PlantedKind kind, NodeId id, bool isSpecial) {
    switch (kind) {
    case PlantedKind::missingTwig:
      return missingTwig(id, isSpecial);
    case PlantedKind::wrongBearer:
      return wrongBearer(id);
    case PlantedKind::foldedBack:
      return foldedBack(id);
    case PlantedKind::besidePoints:
      return besidePoints(id, isSpecial);
    case PlantedKind::falseBranch:
      return isSpecial ? intoAir(id) : ontoWood(id);
    case PlantedKind::shortFoot:
      return shortFoot(id);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool isFree(const std::vector<NodeId>& nodes) const {
    return std::ranges::none_of(nodes, [&](NodeId id) { return isTaken_[indexOf(id)]; });
  }
  void take(const std::vector<NodeId>& nodes) {
    isTaken_.resize(plant_.idEnd(), true); // what is new is an error
    for (const NodeId id : nodes) {
      isTaken_[indexOf(id)] = true;
      if (const auto parent = clean_[id].parent) isTaken_[indexOf(*parent)] = true;
    }
  }

  [[nodiscard]] bool beginsBranch(NodeId id) const {
    const auto parent = clean_[id].parent;
    return parent && nextOnAxis(clean_, *parent) != id;
  }

  /// The points of some nodes that are over 3 spacings from all wood that `isOther`.
  template <class IsOther>
  [[nodiscard]] std::vector<Eigen::Index> pointsOff(const std::vector<NodeId>& nodes,
                                                    const IsOther& isOther) const {
    std::vector<Eigen::Index> points;
    for (const NodeId id : nodes)
      for (const Eigen::Index point : pointsOf_[indexOf(id)])
        if (wood_.distanceToSurface(cloud_.position(point), isOther) > 3 * spacing_)
          points.push_back(point);
    return points;
  }
  [[nodiscard]] std::vector<Eigen::Index> pointsOff(const std::vector<NodeId>& nodes) const {
    return pointsOff(nodes, [&](NodeId id) { return std::ranges::find(nodes, id) == nodes.end(); });
  }

  [[nodiscard]] bool isAir(const Eigen::Vector3d& place) const {
    return !index_.nearestOne((place - cloud_.origin()).cast<float>(),
                              static_cast<float>(4 * spacing_));
  }
  [[nodiscard]] double airShare(const std::vector<Eigen::Vector3d>& line) const {
    int air = 0;
    int all = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      for (double share = 0; share < 1; share += 0.05, ++all)
        air += isAir(line[i - 1] + share * (line[i] - line[i - 1])) ? 1 : 0;
    return all == 0 ? 0 : double(air) / all;
  }

  std::optional<PlantedError> missingTwig(NodeId id, bool isSmall) {
    if (!beginsBranch(id)) return std::nullopt;
    const std::vector<NodeId> carried = downstream(clean_, {id});
    std::ptrdiff_t tips =
        std::ranges::count_if(carried, [&](NodeId node) { return clean_.children(node).empty(); });
    if (tips > 3 || !isFree(carried) || isTaken_[indexOf(*clean_[id].parent)]) return std::nullopt;
    std::vector<Eigen::Index> shown = pointsOff(carried);
    if (shown.size() < 8 || (isSmall && shown.size() >= 30)) return std::nullopt;
    PlantedError error{.kind = PlantedKind::missingTwig, .nodes = {}};
    for (const NodeId node : carried)
      error.points.insert(error.points.end(), pointsOf_[indexOf(node)].begin(),
                          pointsOf_[indexOf(node)].end());
    take(carried);
    eraseAll(id);
    return error;
  }

  void eraseAll(NodeId id) {
    for (const NodeId child : std::vector<NodeId>(plant_.children(id)))
      eraseAll(child);
    plant_.erase(id);
  }

  std::optional<PlantedError> wrongBearer(NodeId id) {
    if (!beginsBranch(id)) return std::nullopt;
    const NodeId bearer = *clean_[id].parent;
    const Axis axis = axisThrough(clean_, id);
    if (!isFree(axis) || pointsOff(axis).size() < 8) return std::nullopt;
    const std::vector<NodeId> carried = downstream(clean_, {id});
    const Eigen::Vector3d place = clean_[id].position;
    std::vector<std::pair<double, NodeId>> others;
    for (const NodeId other : clean_.ids()) {
      const double distance = (clean_[other].position - place).norm();
      if (distance > 60 * spacing_ || distance < 6 * spacing_ + clean_[other].radius) continue;
      if (isTaken_[indexOf(other)] || std::ranges::find(carried, other) != carried.end()) continue;
      const auto path = lengthAlong(clean_, {bearer}, {other});
      if (path && *path < 3 * distance) continue;
      others.emplace_back(distance, other);
    }
    if (others.empty()) return std::nullopt;
    std::ranges::sort(others);
    const NodeId wrong = others[random_.below(std::min<std::size_t>(others.size(), 5))].second;
    if (wood_.distanceToSurface((place + clean_[wrong].position) / 2,
                                [&](NodeId node) { return node != id; }) < 2 * spacing_)
      return std::nullopt; // it would lead along other wood
    take({id});
    isTaken_[indexOf(wrong)] = true;
    plant_.reparent(id, wrong, EdgeType::branching);
    PlantedError error{.kind = PlantedKind::wrongBearer, .nodes = {id}};
    if (const auto next = nextOnAxis(clean_, id)) error.nodes.push_back(*next);
    return error;
  }

  std::optional<PlantedError> foldedBack(NodeId id) {
    if (!beginsBranch(id)) return std::nullopt;
    const NodeId bearer = *clean_[id].parent;
    const Axis axis = axisThrough(clean_, id);
    if (!isFree(axis) || isTaken_[indexOf(bearer)]) return std::nullopt;
    std::size_t first = 0; // clear of its bearer
    const auto isClear = [&](NodeId node) {
      return (clean_[node].position - clean_[bearer].position).norm() >
             clean_[bearer].radius + 4 * spacing_;
    };
    while (first < axis.size() && !isClear(axis[first])) {
      if (clean_.children(axis[first]).size() != 1) return std::nullopt;
      ++first;
    }
    if (first + 1 >= axis.size()) return std::nullopt;
    const std::vector<NodeId> rest(axis.begin() + static_cast<std::ptrdiff_t>(first), axis.end());
    if (pointsOff(rest).size() < 8) return std::nullopt;
    const Eigen::Vector3d place = clean_[rest.front()].position;
    NodeId before = bearer;
    for (auto at = nextOnAxis(clean_, bearer); at; before = *at, at = nextOnAxis(clean_, *at)) {
      const Eigen::Vector3d back = place - clean_[*at].position;
      if (isTaken_[indexOf(*at)] || back.norm() > 60 * spacing_) return std::nullopt;
      const double turn = turnBetween(clean_[*at].position - clean_[before].position, back);
      constexpr double degree = std::numbers::pi / 180;
      if (turn < 138 * degree) continue;
      if (turn > 169 * degree) return std::nullopt;
      take(axis);
      isTaken_[indexOf(*at)] = true;
      plant_.reparent(rest.front(), *at, EdgeType::branching);
      for (std::size_t i = first; i > 0; --i)
        plant_.erase(axis[i - 1]);
      PlantedError error{.kind = PlantedKind::foldedBack, .nodes = {rest[0], rest[1]}};
      for (std::size_t i = 0; i < first; ++i)
        error.points.insert(error.points.end(), pointsOf_[indexOf(axis[i])].begin(),
                            pointsOf_[indexOf(axis[i])].end());
      return error;
    }
    return std::nullopt;
  }

  std::optional<PlantedError> besidePoints(NodeId id, bool isShort) {
    const auto isPlain = [&](NodeId node) {
      return clean_[node].parent && clean_.children(node).size() == 1 && !isTaken_[indexOf(node)];
    };
    if (!isPlain(id) || clean_[*clean_[id].parent].parent == std::nullopt) return std::nullopt;
    const double shift = random_.uniform(1, 2) * std::max(clean_[id].radius, 4 * spacing_);
    const double wanted = (isShort ? random_.uniform(2, 4) : random_.uniform(4, 10)) * shift;
    std::vector<NodeId> run = {id};
    const auto ends = [&] {
      return std::pair(*clean_[run.front()].parent, clean_.children(run.back()).front());
    };
    while ((clean_[ends().second].position - clean_[ends().first].position).norm() < wanted) {
      const auto [low, high] = ends(); // downward and upward
      if (!isPlain(low) || !isPlain(high)) return std::nullopt;
      run.insert(run.begin(), low);
      run.push_back(high);
    }
    std::size_t shown = 0;
    for (const NodeId node : run)
      shown += pointsOf_[indexOf(node)].size();
    if (shown < 8) return std::nullopt;
    const NodeId below = *clean_[run.front()].parent;
    const NodeId above = clean_.children(run.back()).front();
    const Eigen::Vector3d along = (clean_[above].position - clean_[below].position).normalized();
    Eigen::Vector3d aside = random_.direction();
    aside = (aside - aside.dot(along) * along).normalized();
    PlantedError error{.kind = PlantedKind::besidePoints, .nodes = run};
    for (std::size_t i = 0; i < run.size(); ++i) {
      const double share = (double(i) + 1) / (double(run.size()) + 1);
      const double part = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * share);
      plant_.setPosition(run[i], clean_[run[i]].position + part * shift * aside);
      error.points.insert(error.points.end(), pointsOf_[indexOf(run[i])].begin(),
                          pointsOf_[indexOf(run[i])].end());
    }
    error.points.insert(error.points.end(), pointsOf_[indexOf(above)].begin(),
                        pointsOf_[indexOf(above)].end());
    error.nodes.push_back(above);
    error.nodes.push_back(below);
    take(run);
    take({above});
    return error;
  }

  /// A branch that leads from a node along a line of places.
  PlantedError addFalse(NodeId from, const std::vector<Eigen::Vector3d>& line, EdgeType edge) {
    PlantedError error{.kind = PlantedKind::falseBranch, .nodes = {}};
    NodeId at = from;
    for (std::size_t i = 1; i < line.size(); ++i) {
      at = plant_.add({.position = line[i],
                       .radius = std::min(clean_[from].radius, spacing_),
                       .parent = at,
                       .edge = i == 1 ? edge : EdgeType::successor});
      error.nodes.push_back(at);
    }
    take({from});
    return error;
  }

  std::optional<PlantedError> intoAir(NodeId id) {
    if (isTaken_[indexOf(id)] || clean_.children(id).empty()) return std::nullopt;
    const double length = random_.uniform(15, 50) * spacing_ + clean_[id].radius;
    std::vector<Eigen::Vector3d> line = {clean_[id].position};
    const Eigen::Vector3d direction = random_.direction();
    for (int i = 1; i <= 3; ++i)
      line.push_back(line.front() + length / 3 * i * direction +
                     length / 30 * i * random_.direction());
    if (airShare(line) < 0.6 || !isAir(line.back())) return std::nullopt;
    return addFalse(id, line, EdgeType::branching);
  }

  std::optional<PlantedError> ontoWood(NodeId id) {
    if (isTaken_[indexOf(id)] || !clean_.children(id).empty() || !clean_[id].parent)
      return std::nullopt;
    const Eigen::Vector3d place = clean_[id].position;
    std::vector<NodeId> others;
    for (const NodeId other : clean_.ids()) {
      const double distance = (clean_[other].position - place).norm() - clean_[other].radius;
      if (distance < 15 * spacing_ || distance > 50 * spacing_) continue;
      const auto path = lengthAlong(clean_, {id}, {other});
      if (!path || *path > 3 * distance) others.push_back(other);
    }
    if (others.empty()) return std::nullopt;
    const NodeId other = others[random_.below(others.size())];
    const Eigen::Vector3d toOther = clean_[other].position - place;
    const Eigen::Vector3d end =
        place + (1 - (clean_[other].radius + 0.5 * spacing_) / toOther.norm()) * toOther;
    const std::vector<Eigen::Vector3d> line = {place, (place + end) / 2, end};
    if (airShare(line) < 0.5) return std::nullopt;
    return addFalse(id, line, EdgeType::successor);
  }

  std::optional<PlantedError> shortFoot(NodeId id) {
    if (clean_[id].parent || downstream(clean_, {id}).size() * 2 < clean_.size())
      return std::nullopt;
    const auto first = nextOnAxis(clean_, id);
    if (!first || isTaken_[indexOf(id)]) return std::nullopt;
    double left = random_.uniform(3, 8) * std::max(clean_[*first].radius, 5 * spacing_);
    NodeId at = id;
    std::vector<NodeId> low; // that lose wood
    while (true) {
      const auto next = nextOnAxis(clean_, at);
      if (!next || clean_.children(at).size() != 1) return std::nullopt;
      low.push_back(*next);
      const double length = edgeLength(clean_, *next);
      if (length > left) break;
      left -= length;
      at = *next;
    }
    const NodeId next = low.back();
    const Eigen::Vector3d along = (clean_[next].position - clean_[at].position).normalized();
    const Eigen::Vector3d place = clean_[at].position + left * along;
    PlantedError error{.kind = PlantedKind::shortFoot, .nodes = {at}};
    for (const NodeId node : low)
      for (const Eigen::Index point : pointsOf_[indexOf(node)])
        if ((cloud_.position(point) - place).dot(along) < 0) error.points.push_back(point);
    if (error.points.size() < 8) return std::nullopt;
    if (at != id) {
      plant_.makeRoot(at);
      eraseAll(id);
    }
    plant_.setPosition(at, place);
    take(low);
    return error;
  }

  const Skeleton& clean_;
  Skeleton plant_;
  const PointCloud& cloud_;
  double spacing_; // [L]
  Random random_;
  SpatialIndex index_;
  PointDistances distances_;                        // to the clean one
  EdgeIndex wood_;                                  // likewise
  std::vector<bool> isTaken_;                       // by id
  std::vector<std::vector<Eigen::Index>> pointsOf_; // by id
  std::vector<PlantedError> errors_;
};

} // namespace

const char* nameOf(PlantedKind kind) {
  switch (kind) {
  case PlantedKind::missingTwig:
    return "missing twig";
  case PlantedKind::wrongBearer:
    return "wrong bearer";
  case PlantedKind::foldedBack:
    return "folded back";
  case PlantedKind::besidePoints:
    return "beside its points";
  case PlantedKind::falseBranch:
    return "false branch";
  case PlantedKind::shortFoot:
    return "short foot";
  }
  return "";
}

PlantedPlant withPlantedErrors(const Skeleton& skeleton,
                               const std::shared_ptr<const PointCloud>& cloud, double spacing,
                               std::uint64_t seed, const std::array<int, plantedKinds>& counts) {
  Planter planter(skeleton, cloud, spacing, seed);
  for (int kind = plantedKinds - 1; kind >= 0; --kind)
    planter.plant(static_cast<PlantedKind>(kind), counts[static_cast<std::size_t>(kind)]);
  return std::move(planter).result();
}

bool isOf(const PlantedError& error, const Finding& finding) {
  if (!finding.points.empty()) {
    std::size_t shared = 0;
    for (const Eigen::Index point : finding.points)
      shared += std::ranges::binary_search(error.points, point) ? 1 : 0;
    return 2 * shared >= finding.points.size();
  }
  return std::ranges::any_of(nodesOf(finding), [&](NodeId id) {
    return std::ranges::find(error.nodes, id) != error.nodes.end();
  });
}

} // namespace espalier::test
