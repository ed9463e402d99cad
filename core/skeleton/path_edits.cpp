#include "core/skeleton/path_edits.h"

#include "core/base/shown_message.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {
namespace {

/// Does a node only continue an axis?
bool isPlain(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  return node.parent && !node.isMarked && node.entities.size() < 2 &&
         skeleton.children(id).size() == 1 && nextOnAxis(skeleton, id);
}

/// Length from the first node to each of a path [L].
std::vector<double> lengths(const Skeleton& skeleton, const std::vector<NodeId>& path) {
  std::vector<double> result = {0};
  for (std::size_t i = 1; i < path.size(); ++i)
    result.push_back(result.back() +
                     (skeleton[path[i]].position - skeleton[path[i - 1]].position).norm());
  return result;
}

void requireBetween(const std::vector<NodeId>& path) {
  if (path.size() < 3)
    throw ShownError(
        {Shown::tr("there is no node between the ends: choose the two ends of a longer path")});
}

struct Place {
  Eigen::Vector3d position; // [L]
  double radius;            // [L]
  RadiusOrigin origin;
};

/// The place and radius on a polyline at a length from its start.
struct Line {
  std::vector<Place> places;
  std::vector<double> at; // length from the first [L]

  [[nodiscard]] Place place(double length) const {
    const auto behind = std::ranges::upper_bound(at, length);
    const std::size_t next =
        std::clamp<std::size_t>(static_cast<std::size_t>(behind - at.begin()), 1, at.size() - 1);
    const double edge = at[next] - at[next - 1];
    const double share = edge > 0 ? std::clamp((length - at[next - 1]) / edge, 0.0, 1.0) : 0;
    const Place& from = places[next - 1];
    const Place& to = places[next];
    return {from.position + share * (to.position - from.position),
            from.radius + share * (to.radius - from.radius), to.origin};
  }
};

/// A part of a skeleton whose nodes may be spaced anew: `inner` lie between two that stay.
struct CutStretch {
  std::vector<NodeId> inner; // from below
  NodeId end{};              // above them; the parent of the lowest is the other one
  Line line;
  std::size_t count = 0; // of inner nodes, when spaced
};

std::vector<CutStretch> stretchesOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                                    double step) {
  std::vector<bool> isChosen(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isChosen[indexOf(id)] = true;
  const auto isInner = [&](NodeId id) {
    return isChosen[indexOf(id)] && isPlain(skeleton, id) &&
           isChosen[indexOf(*skeleton[id].parent)] &&
           isChosen[indexOf(skeleton.children(id).front())];
  };
  std::vector<CutStretch> result;
  for (const NodeId id : skeleton.ids()) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    if (!isChosen[indexOf(id)] || !parent || !isChosen[indexOf(*parent)] || isInner(id)) continue;
    CutStretch stretch{.inner = {}, .end = id, .line = {}};
    NodeId foot = *parent;
    for (; isInner(foot); foot = *skeleton[foot].parent)
      stretch.inner.push_back(foot);
    std::ranges::reverse(stretch.inner);
    std::vector<NodeId> path = {foot};
    path.insert(path.end(), stretch.inner.begin(), stretch.inner.end());
    path.push_back(id);
    stretch.line.at = lengths(skeleton, path);
    for (const NodeId each : path)
      stretch.line.places.push_back(
          {skeleton[each].position, skeleton[each].radius, skeleton[each].origin});
    const double edges = std::round(stretch.line.at.back() / step);
    constexpr double most = 1e6;
    if (edges > most)
      throw ShownError(
          {Shown::tr("edges that short would make over a million nodes: choose a greater length")});
    stretch.count = static_cast<std::size_t>(std::max(edges, 1.0)) - 1;
    result.push_back(std::move(stretch));
  }
  return result;
}

/// Removes or adds nodes until there are as many as are to be, then moves them.
void space(SkeletonEditor& editor, const CutStretch& stretch) {
  std::vector<NodeId> kept;
  const std::size_t before = stretch.inner.size();
  for (std::size_t i = 0; i < before; ++i) {
    const std::size_t target = std::min(stretch.count, before); // evenly, the others go
    if ((i + 1) * target / before > i * target / before)
      kept.push_back(stretch.inner[i]);
    else
      removeNode(editor, stretch.inner[i]);
  }
  while (kept.size() < stretch.count)
    kept.push_back(splitEdge(editor, stretch.end, 0.5));
  const double total = stretch.line.at.back();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(stretch.count + 1);
    const Place place = stretch.line.place(share * total);
    editor.setPosition(kept[i], place.position);
    editor.setRadius(kept[i], place.radius, place.origin);
  }
}

/// The nodes of an axis, after the one that bears it.
std::vector<NodeId> withBearer(const Skeleton& skeleton, const Axis& axis) {
  std::vector<NodeId> result;
  if (skeleton[axis.front()].parent) result.push_back(*skeleton[axis.front()].parent);
  result.insert(result.end(), axis.begin(), axis.end());
  return result;
}

/// The weighted mean of node `i` and its neighbors on a line of nodes. pre: it is no end
Eigen::Vector3d meanAround(const Skeleton& skeleton, const std::vector<NodeId>& line,
                           const std::vector<double>& at, std::size_t i, double width) {
  Eigen::Vector3d sum = skeleton[line[i]].position;
  double weights = 1;
  for (std::size_t k = 1; k <= std::min(i, line.size() - 1 - i); ++k) {
    constexpr double reach = 3; // standard deviations
    const double before = (at[i] - at[i - k]) / width;
    const double behind = (at[i + k] - at[i]) / width;
    if (std::min(before, behind) > reach) break;
    for (const auto& [node, distance] : {std::pair(line[i - k], before), {line[i + k], behind}}) {
      const double weight = std::exp(-distance * distance / 2);
      sum += weight * skeleton[node].position;
      weights += weight;
    }
  }
  return sum / weights;
}

} // namespace

double meanEdgeLength(const Skeleton& skeleton) {
  double sum = 0;
  std::size_t count = 0;
  for (const NodeId id : skeleton.ids()) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    if (!parent) continue;
    sum += (skeleton[id].position - skeleton[*parent].position).norm();
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

void straighten(SkeletonEditor& editor, const std::vector<NodeId>& path) {
  requireBetween(path);
  const std::vector<double> at = lengths(editor.skeleton(), path);
  if (at.back() == 0) return; // all in one place
  const Eigen::Vector3d from = editor.skeleton()[path.front()].position;
  const Eigen::Vector3d to = editor.skeleton()[path.back()].position;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    editor.setPosition(path[i], from + at[i] / at.back() * (to - from));
}

void interpolateRadii(SkeletonEditor& editor, const std::vector<NodeId>& path) {
  requireBetween(path);
  for (const NodeId end : {path.front(), path.back()})
    if (editor.skeleton()[end].radius == 0)
      throw ShownError({Shown::tr("node %1 has no radius yet: type one in the inspector first"),
                        {std::to_string(indexOf(end))}});
  const std::vector<double> at = lengths(editor.skeleton(), path);
  const double from = editor.skeleton()[path.front()].radius;
  const double to = editor.skeleton()[path.back()].radius;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double share = at.back() > 0 ? at[i] / at.back() : 0;
    editor.setRadius(path[i], from + share * (to - from), {.source = RadiusSource::extrapolated});
  }
}

void thinOut(SkeletonEditor& editor, const std::vector<NodeId>& path) {
  requireBetween(path);
  std::vector<NodeId> plain;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    if (isPlain(editor.skeleton(), path[i])) plain.push_back(path[i]);
  if (plain.empty())
    throw ShownError(
        {Shown::tr("all nodes between the ends branch, or a unit starts there: nothing can go")});
  for (const NodeId id : plain)
    removeNode(editor, id);
}

void smooth(SkeletonEditor& editor, const std::vector<NodeId>& nodes, double width) {
  assert(width > 0);
  const Skeleton& skeleton = editor.skeleton();
  std::vector<bool> isWaiting(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isWaiting[indexOf(id)] = true;
  std::vector<std::pair<NodeId, Eigen::Vector3d>> moved;
  for (const NodeId id : nodes) {
    if (!isWaiting[indexOf(id)]) continue; // its axis has had its turn
    const Axis axis = axisThrough(skeleton, id);
    const std::vector<NodeId> line = withBearer(skeleton, axis);
    const std::vector<double> at = lengths(skeleton, line);
    for (std::size_t i = line.size() - axis.size(); i < line.size(); ++i) {
      if (!isWaiting[indexOf(line[i])]) continue;
      isWaiting[indexOf(line[i])] = false;
      if (i > 0 && i + 1 < line.size())
        moved.emplace_back(line[i], meanAround(skeleton, line, at, i, width));
    }
  }
  for (const auto& [id, position] : moved)
    editor.setPosition(id, position);
}

void resample(SkeletonEditor& editor, const std::vector<NodeId>& nodes, double step) {
  assert(step > 0);
  for (const CutStretch& stretch : stretchesOf(editor.skeleton(), nodes, step))
    space(editor, stretch);
}

} // namespace espalier
