#include "core/evaluate/differences/near_edges.h"

#include "core/base/parallel.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace espalier {
namespace {

constexpr std::size_t none = SIZE_MAX;

/// Share of an edge that is near, from even samples.
double nearShare(const Skeleton& skeleton, NodeId id, const EdgeIndex& other, double tolerance) {
  const Frustum edge = centerLine(skeleton, id);
  const double length = edge.length();
  const double samples = std::clamp(std::ceil(2 * length / tolerance), 1.0, 1e5);
  double near = 0;
  for (double i = 0; i < samples;) {
    const double distance = other.nearest(edge.at((i + 0.5) / samples))->distance;
    // No distance changes by more than the path length: what lies that far on is alike,
    // and not measured.
    const double alike =
        length > 0 ? std::floor(std::abs(distance - tolerance) * samples / length) : 0;
    const double next = std::min(i + std::max(1.0, alike), samples);
    if (distance <= tolerance) near += next - i;
    i = next;
  }
  return near / samples;
}

double lengthOf(const Skeleton& skeleton, const std::vector<NodeId>& stretch) {
  double sum = 0;
  for (const NodeId id : stretch)
    sum += edgeLength(skeleton, id);
  return sum;
}

/// How a stretch, all of whose edges have one flag, touches edges of the other.
struct Ends {
  bool below = false;
  bool above = false;
};

Ends endsOf(const Skeleton& skeleton, const std::vector<NodeId>& stretch,
            const std::vector<bool>& near) {
  Ends ends;
  const bool flag = near[indexOf(stretch.front())];
  if (const auto parent = skeleton[stretch.front()].parent)
    ends.below = near[indexOf(*parent)] != flag;
  for (const NodeId id : stretch)
    for (const NodeId child : skeleton.children(id))
      ends.above = ends.above || near[indexOf(child)] != flag;
  return ends;
}

void setAll(std::vector<bool>& near, const std::vector<NodeId>& stretch, bool flag) {
  for (const NodeId id : stretch)
    near[indexOf(id)] = flag;
}

} // namespace

std::vector<bool> nearEdges(const Skeleton& skeleton, const Skeleton& other, double tolerance,
                            const Progress& progress) {
  const EdgeIndex index(other);
  const std::vector<NodeId> ids = skeleton.ids();
  std::vector<std::uint8_t> nearOfEach(ids.size()); // not bools, which threads cannot write apart
  parallelFor(
      static_cast<Eigen::Index>(ids.size()),
      [&](Eigen::Index i) {
        const auto k = static_cast<std::size_t>(i);
        nearOfEach[k] = nearShare(skeleton, ids[k], index, tolerance) >= 0.5 ? 1 : 0;
      },
      progress);
  std::vector<bool> near(skeleton.idEnd(), false);
  for (std::size_t k = 0; k < ids.size(); ++k)
    near[indexOf(ids[k])] = nearOfEach[k] != 0;

  for (const std::vector<NodeId>& island : stretches(skeleton, near, true)) {
    const Ends ends = endsOf(skeleton, island, near);
    if (ends.below && ends.above && lengthOf(skeleton, island) < 3 * tolerance)
      setAll(near, island, false);
  }
  for (const std::vector<NodeId>& rest : stretches(skeleton, near, false)) {
    const Ends ends = endsOf(skeleton, rest, near);
    if ((ends.below || ends.above) && lengthOf(skeleton, rest) < tolerance)
      setAll(near, rest, true);
  }
  return near;
}

std::vector<std::vector<NodeId>> stretches(const Skeleton& skeleton, const std::vector<bool>& flags,
                                           bool value) {
  std::vector<std::vector<NodeId>> found;
  std::vector<std::size_t> stretchOf(skeleton.idEnd(), none);
  for (const NodeId id : skeleton.ids()) {
    if (flags[indexOf(id)] != value) continue;
    const auto& parent = skeleton[id].parent;
    std::size_t& stretch = stretchOf[indexOf(id)];
    stretch = parent ? stretchOf[indexOf(*parent)] : none;
    if (stretch == none) {
      stretch = found.size();
      found.emplace_back();
    }
    found[stretch].push_back(id);
  }
  return found;
}

} // namespace espalier
