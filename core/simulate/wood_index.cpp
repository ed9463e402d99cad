#include "core/simulate/wood_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint32_t piecesPerBox = 4;
constexpr std::size_t maxDepth = 64; // of a tree halved at each step: more than 2^32 pieces

/// One over each coordinate. No infinity for 0: along a side of a box it would give 0 * infinity,
/// and the NaN would hide the box.
Eigen::Array3d inverseOf(const Eigen::Vector3d& direction) {
  return direction.unaryExpr([](double x) { return std::abs(x) > 1e-300 ? 1 / x : 1e300; }).array();
}

/// Where the ray enters the box, or infinity if it misses it or enters beyond `range`.
double entry(const Eigen::AlignedBox3d& box, const Ray& ray, const Eigen::Array3d& inverse,
             double range) {
  double from = 0;
  double to = range;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - ray.origin[axis]) * inverse[axis];
    const double b = (box.max()[axis] - ray.origin[axis]) * inverse[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to ? from : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d middle(const WoodPiece& piece) {
  return 0.5 * (piece.from + piece.to);
}

} // namespace

WoodIndex::WoodIndex(std::vector<WoodPiece> wood) : wood_(std::move(wood)) {
  if (wood_.empty()) return;
  boxes_.reserve(wood_.size());
  boxes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(wood_.size()));
}

void WoodIndex::split(std::uint32_t box, std::uint32_t first, std::uint32_t count) {
  Eigen::AlignedBox3d bounds;
  Eigen::AlignedBox3d middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    bounds.extend(boundsOf(wood_[i]));
    middles.extend(middle(wood_[i]));
  }
  if (count <= piecesPerBox) {
    boxes_[box] = {bounds, first, count};
    return;
  }
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(wood_.begin() + first, wood_.begin() + first + half,
                   wood_.begin() + first + count, [&](const WoodPiece& a, const WoodPiece& b) {
                     return std::pair(middle(a)[axis], a.node) < std::pair(middle(b)[axis], b.node);
                   });
  const auto children = static_cast<std::uint32_t>(boxes_.size());
  boxes_.resize(boxes_.size() + 2);
  boxes_[box] = {bounds, children, 0};
  split(children, first, half);
  split(children + 1, first + half, count - half);
}

Eigen::AlignedBox3d WoodIndex::bounds() const {
  return boxes_.empty() ? Eigen::AlignedBox3d{} : boxes_.front().bounds;
}

std::optional<WoodHit> WoodIndex::firstHit(const Ray& ray, double range) const {
  std::optional<WoodHit> best;
  if (boxes_.empty()) return best;
  const Eigen::Array3d inverse = inverseOf(ray.direction);
  std::array<std::pair<double, std::uint32_t>, maxDepth> open;
  std::size_t size = 0;
  open[size++] = {entry(boxes_[0].bounds, ray, inverse, range), 0};
  while (size > 0) {
    const auto [start, at] = open[--size];
    if (!(start < range)) continue;
    const Box& box = boxes_[at];
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i)
      if (const std::optional<WoodHit> next = hit(wood_[i], ray); next && next->range < range) {
        best = next;
        range = next->range;
      }
    if (box.count > 0) continue;
    std::pair near{entry(boxes_[box.first].bounds, ray, inverse, range), box.first};
    std::pair far{entry(boxes_[box.first + 1].bounds, ray, inverse, range), box.first + 1};
    if (far.first < near.first) std::swap(near, far);
    open[size++] = far; // the nearer box comes off first
    open[size++] = near;
  }
  return best;
}

double WoodIndex::distance(const Eigen::Vector3d& place, double reach) const {
  if (boxes_.empty()) return reach;
  std::array<std::uint32_t, maxDepth> open;
  std::size_t size = 0;
  open[size++] = 0;
  while (size > 0) {
    const Box& box = boxes_[open[--size]];
    if (box.bounds.exteriorDistance(place) > std::max(reach, 0.0)) continue;
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i)
      reach = std::min(reach, signedDistance(wood_[i], place));
    if (box.count > 0) continue;
    open[size++] = box.first;
    open[size++] = box.first + 1;
  }
  return reach;
}

} // namespace espalier
