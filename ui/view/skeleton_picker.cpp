#include "ui/view/skeleton_picker.h"

#include "ui/view/visibility.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

namespace espalier {
namespace {

using Places = std::vector<std::optional<ScreenMap::Place>>;

/// What is closer than this on the screen counts as equally near [logical pixels].
constexpr double tie = 1.5;

/// Keeps the candidate nearest to the pointer, or on a tie nearest to the eye.
struct Nearest {
  std::size_t slot = SIZE_MAX;
  double distance = std::numeric_limits<double>::infinity(); // [pixels]
  double depth = 0;
  double fraction = 0; // edges only
  double onScreen = 0; // likewise: the same as it is drawn

  void offer(const Nearest& other) {
    const bool nearer = other.distance < distance - tie;
    const bool tied = other.distance < distance + tie && other.depth < depth;
    if (slot == SIZE_MAX || nearer || tied) *this = other;
  }
};

Nearest nearestNode(const SkeletonGlyphs& glyphs, const Places& places,
                    const Eigen::Vector2d& pixel, double reach,
                    const std::function<bool(std::size_t)>& isShown, const Visibility* visibility) {
  Nearest best;
  for (std::size_t slot = 0; slot < places.size(); ++slot) {
    if (glyphs.nodes()[slot].shape == NodeShape::none || !places[slot]) continue;
    const double distance = (places[slot]->pixel - pixel).norm();
    if (distance > reach || !isShown(slot)) continue;
    if (visibility != nullptr && visibility->hidesNode(slot, *places[slot])) continue;
    best.offer({slot, distance, places[slot]->depth});
  }
  return best;
}

/// The fraction of a segment, from `from` to `to`, that is nearest to a pixel.
double nearestFraction(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                       const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d along = to - from;
  const double squared = along.squaredNorm();
  return squared > 0 ? std::clamp(along.dot(pixel - from) / squared, 0.0, 1.0) : 0;
}

struct EdgeEnds {
  ScreenMap::Place parent, child;
};

std::optional<Nearest> edgeUnder(std::size_t slot, const EdgeEnds& ends,
                                 const Eigen::Vector2d& pixel, bool perspective, double reach) {
  const double onScreen = nearestFraction(ends.parent.pixel, ends.child.pixel, pixel);
  const Eigen::Vector2d foot =
      ends.parent.pixel + onScreen * (ends.child.pixel - ends.parent.pixel);
  const double distance = (foot - pixel).norm();
  if (distance > reach) return std::nullopt;
  // In perspective equal steps on the screen are longer far away: 1/depth is what is linear.
  const double parentWeight = perspective ? (1 - onScreen) / ends.parent.depth : 1 - onScreen;
  const double childWeight = perspective ? onScreen / ends.child.depth : onScreen;
  const double fraction = childWeight / (parentWeight + childWeight);
  const double depth = ends.parent.depth + fraction * (ends.child.depth - ends.parent.depth);
  return Nearest{slot, distance, depth, fraction, onScreen};
}

} // namespace

Pick pickSkeleton(const SkeletonGlyphs& glyphs, const ScreenMap& map, const Eigen::Vector2d& pixel,
                  double reach, const Visibility* visibility, const ClipVolume& clip) {
  const std::size_t count = glyphs.nodes().size();
  Places places(count);
  for (std::size_t slot = 0; slot < count; ++slot)
    if (glyphs.nodes()[slot].shape != NodeShape::none)
      places[slot] = map.project(glyphs.position(slot));
  const auto isShown = [&](std::size_t slot) {
    return clip.contains(Eigen::Vector3f(glyphs.nodes()[slot].position.data()));
  };

  Pick pick;
  const Nearest node = nearestNode(glyphs, places, pixel, reach, isShown, visibility);
  if (node.slot != SIZE_MAX) {
    pick.node = NodeId{static_cast<std::uint32_t>(node.slot)};
    return pick;
  }
  Nearest best;
  for (std::size_t slot = 0; slot < count; ++slot) {
    const EdgeGlyph& edge = glyphs.edges()[slot];
    if (edge.shape == EdgeShape::none || !places[slot]) continue;
    const auto parent =
        map.project(glyphs.origin() + Eigen::Vector3f(edge.parent.data()).cast<double>());
    if (!parent) continue;
    const auto found = edgeUnder(slot, {*parent, *places[slot]}, pixel, map.isPerspective(), reach);
    if (!found) continue;
    const Eigen::Vector3f parentPlace(edge.parent.data());
    const Eigen::Vector3f childPlace(edge.child.data());
    const auto part = static_cast<float>(found->fraction);
    if (!clip.contains(parentPlace + part * (childPlace - parentPlace))) continue;
    const Eigen::Vector2d foot =
        parent->pixel + found->onScreen * (places[slot]->pixel - parent->pixel);
    const ScreenMap::Place at{foot, found->depth};
    if (visibility != nullptr && visibility->hidesEdge(edge, found->fraction, at)) continue;
    best.offer(*found);
  }
  if (best.slot == SIZE_MAX) return pick;
  const EdgeGlyph& edge = glyphs.edges()[best.slot];
  const Eigen::Vector3d from = Eigen::Vector3f(edge.parent.data()).cast<double>();
  const Eigen::Vector3d to = Eigen::Vector3f(edge.child.data()).cast<double>();
  pick.edge = EdgePick{NodeId{static_cast<std::uint32_t>(best.slot)}, best.fraction,
                       glyphs.origin() + from + best.fraction * (to - from)};
  return pick;
}

} // namespace espalier
