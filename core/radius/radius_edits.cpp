#include "core/radius/radius_edits.h"

#include "core/base/shown_message.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace espalier {
namespace {

double distance(const Skeleton& skeleton, NodeId a, NodeId b) {
  return (skeleton[a].position - skeleton[b].position).norm();
}

/// A pipe from a node whose radius stands: radius = foot * (carried / carriedByFoot)^exponent.
struct Pipe {
  double foot;          // radius [L]
  double carriedByFoot; // nodes
  double exponent;

  [[nodiscard]] double radius(double carried) const {
    return foot * std::pow(carried / carriedByFoot, exponent);
  }
};

/// @param apex [L]; none: the exponent of the published structures
Pipe pipeAt(double foot, double carried, std::optional<double> apex) {
  double exponent = 1.0 / 3;
  if (apex && carried > 1)
    exponent = std::max(0.0, std::log(foot / *apex) / std::log(carried)); // thins towards the tips
  return {.foot = foot, .carriedByFoot = carried, .exponent = exponent};
}

/// The median radius of the tips among `nodes` that have one.
std::optional<double> apexRadius(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  std::vector<double> tips;
  for (const NodeId id : nodes)
    if (skeleton.children(id).empty() && skeleton[id].radius > 0)
      tips.push_back(skeleton[id].radius);
  if (tips.empty()) return std::nullopt;
  const auto middle = tips.begin() + static_cast<std::ptrdiff_t>(tips.size() / 2);
  std::ranges::nth_element(tips, middle);
  return *middle;
}

/// What a node carries, itself first.
std::vector<NodeId> parentsFirst(const Skeleton& skeleton, NodeId from) {
  std::vector<NodeId> result = {from};
  for (std::size_t next = 0; next < result.size(); ++next) {
    const std::vector<NodeId>& children = skeleton.children(result[next]);
    result.insert(result.end(), children.begin(), children.end());
  }
  return result;
}

/// Number of nodes that each of `nodes` carries, itself included, by id.
/// pre: parents come before their children, and the first carries the others
std::vector<double> carriedNodes(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  std::vector<double> result(skeleton.idEnd(), 1);
  for (auto id = nodes.rbegin(); *id != nodes.front(); ++id)
    result[indexOf(*skeleton[*id].parent)] += result[indexOf(*id)];
  return result;
}

} // namespace

void smoothRadii(SkeletonEditor& editor, const std::vector<NodeId>& nodes) {
  const Skeleton& skeleton = editor.skeleton();
  std::vector<std::pair<NodeId, double>> smoothed;
  for (const NodeId id : nodes) {
    const std::optional<NodeId> below = previousOnAxis(skeleton, id);
    const std::optional<NodeId> above = nextOnAxis(skeleton, id);
    if (!below || !above) continue;
    const double radius = skeleton[id].radius;
    const double start = skeleton[*below].radius;
    const double end = skeleton[*above].radius;
    if (radius == 0 || start == 0 || end == 0) continue;
    const double fromBelow = distance(skeleton, *below, id);
    const double whole = fromBelow + distance(skeleton, id, *above);
    const double share = whole > 0 ? fromBelow / whole : 0.5;
    smoothed.emplace_back(id, (radius + start + share * (end - start)) / 2);
  }
  for (const auto& [id, radius] : smoothed)
    editor.setRadius(id, radius, {.source = RadiusSource::extrapolated});
}

void limitRadii(SkeletonEditor& editor, const std::vector<NodeId>& nodes) {
  const Skeleton& skeleton = editor.skeleton();
  std::vector<bool> isChosen(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isChosen[indexOf(id)] = true;
  std::vector<double> known(skeleton.idEnd(), 0); // the radius here, or the nearest below
  for (const NodeId id : skeleton.ids()) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    const double limit = parent ? known[indexOf(*parent)] : 0;
    const double radius = skeleton[id].radius;
    const bool isOver = isChosen[indexOf(id)] && limit > 0 && radius > limit;
    if (isOver) editor.setRadius(id, limit, {.source = RadiusSource::extrapolated});
    known[indexOf(id)] = isOver || radius == 0 ? limit : radius;
  }
}

void pipeModelFrom(SkeletonEditor& editor, NodeId from, const std::vector<NodeId>& kept) {
  const Skeleton& skeleton = editor.skeleton();
  if (skeleton[from].radius == 0)
    throw ShownError(
        {Shown::tr("node %1 has no radius yet: measure it, or type one in the inspector"),
         {std::to_string(indexOf(from))}});
  if (skeleton.children(from).empty())
    throw ShownError({Shown::tr("node %1 carries nothing: choose a node farther from the tips"),
                      {std::to_string(indexOf(from))}});
  std::vector<bool> isKept(skeleton.idEnd(), false);
  for (const NodeId id : kept)
    isKept[indexOf(id)] = skeleton[id].radius > 0;
  const std::vector<NodeId> nodes = parentsFirst(skeleton, from);
  const std::vector<double> carried = carriedNodes(skeleton, nodes);
  const std::optional<double> apex = apexRadius(skeleton, nodes);
  std::vector<std::optional<Pipe>> pipes(skeleton.idEnd());
  std::vector<std::pair<NodeId, double>> radii;
  for (const NodeId id : nodes) {
    std::optional<Pipe>& pipe = pipes[indexOf(id)];
    if (id == from || isKept[indexOf(id)]) {
      pipe = pipeAt(skeleton[id].radius, carried[indexOf(id)], apex);
      continue;
    }
    pipe = pipes[indexOf(*skeleton[id].parent)];
    radii.emplace_back(id, pipe->radius(carried[indexOf(id)]));
  }
  for (const auto& [id, radius] : radii)
    editor.setRadius(id, radius, {.source = RadiusSource::extrapolated});
}

std::vector<NodeId> confirmedNodes(const Skeleton& skeleton,
                                   const std::vector<std::pair<NodeId, double>>& measured,
                                   double share) {
  std::vector<NodeId> result;
  for (const auto& [id, radius] : measured)
    if (std::abs(skeleton[id].radius - radius) <= share * radius) result.push_back(id);
  return result;
}

} // namespace espalier
