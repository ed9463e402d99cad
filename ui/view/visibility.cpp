#include "ui/view/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

constexpr double cell = 2;          // [logical pixels]
constexpr int largestHalf = 24;     // of what a point covers [cells]
constexpr double spread = 0.75;     // that far, in spacings, a point stands for its surface
constexpr double glyphReach = 3;    // [logical pixels], what of a node is looked at
constexpr int mostOfNine = 7;       // of the places looked at
constexpr double radiusSlack = 1.5; // radii are measured to about a third
constexpr double leastSine = 0.35;  // sine between axis and line of sight: wood seen end on
constexpr double noise = 3;         // how thick a surface of points is, in their spacings

} // namespace

Visibility::Visibility(const Scene& scene, const ScreenMap& screen, const QRectF& part)
    : scene_(scene), screen_(screen), part_(screen, scene.origin(), part.adjusted(-8, -8, 8, 8)),
      clip_(scene.clipVolume(screen.camera())), focus_(scene.focusDepths(screen.camera())),
      columns_(static_cast<int>(std::ceil(std::max(0.0, part_.box().width()) / cell))),
      rows_(static_cast<int>(std::ceil(std::max(0.0, part_.box().height()) / cell))),
      depths_(std::size_t(columns_) * std::size_t(rows_), std::numeric_limits<float>::infinity()) {
  if (depths_.empty()) return;
  if (scene.points.visible) addPoints(scene.points);
  if (scene.skeletonVisible && scene.showRadii) addFrusta(scene.skeleton);
}

void Visibility::add(const ScreenPart::Place& at, int half) {
  const float x = at.pixel.x() * static_cast<float>(1 / cell);
  const float y = at.pixel.y() * static_cast<float>(1 / cell);
  if (half == 0) { // the most, from afar
    if (!(x >= 0 && y >= 0 && x < static_cast<float>(columns_) && y < static_cast<float>(rows_)))
      return;
    float& least = depths_[std::size_t(y) * std::size_t(columns_) + std::size_t(x)];
    least = std::min(least, at.depth);
    return;
  }
  const auto reach = static_cast<float>(half);
  if (!(x >= -reach && y >= -reach)) return;
  if (!(x < static_cast<float>(columns_) + reach && y < static_cast<float>(rows_) + reach)) return;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const int lastColumn = std::min(columns_ - 1, column + half);
  const int lastRow = std::min(rows_ - 1, row + half);
  for (int r = std::max(0, row - half); r <= lastRow; ++r)
    for (int c = std::max(0, column - half); c <= lastColumn; ++c) {
      float& least = depths_[std::size_t(r) * std::size_t(columns_) + std::size_t(c)];
      least = std::min(least, at.depth);
    }
}

void Visibility::addPoints(const PointLayer& layer) {
  const double wide = spread * layer.spacing; // [L]
  const auto act = [&](Eigen::Index begin, Eigen::Index end) {
    const double depth = part_.place(layer.positions->col(begin)).depth;
    const double cells = wide / (screen_.pixelSize(std::max(depth, 1e-12)) * cell);
    const int half = static_cast<int>(std::lround(std::min(cells, double(largestHalf))));
    for (Eigen::Index i = begin; i < end; ++i) {
      const ScreenPart::Place at = part_.place(layer.positions->col(i));
      if (part_.isBeforeEye(at) && scene_.isPointShown(i) && !focus_.isPassed(at.depth) &&
          clip_.contains(layer.positions->col(i)))
        add(at, half);
    }
  };
  layer.boxes.forEachRun(
      [&](const Eigen::AlignedBox3f& box) { return part_.mayMeet(box, float(wide)); }, act);
}

void Visibility::addFrusta(const SkeletonGlyphs& glyphs) {
  for (const EdgeGlyph& edge : glyphs.edges()) {
    if (edge.shape == EdgeShape::none) continue;
    Eigen::AlignedBox3f box(Eigen::Vector3f(edge.parent.data()));
    box.extend(Eigen::Vector3f(edge.child.data()));
    if (part_.mayMeet(box, std::max(edge.parentRadius, edge.childRadius))) addFrustum(edge);
  }
}

void Visibility::addFrustum(const EdgeGlyph& edge) {
  const Eigen::Vector3f from(edge.parent.data());
  const Eigen::Vector3f to(edge.child.data());
  const ScreenPart::Place begin = part_.place(from);
  const ScreenPart::Place end = part_.place(to);
  if (!part_.isBeforeEye(begin) || !part_.isBeforeEye(end)) return;
  const double length = (end.pixel - begin.pixel).norm() / cell;
  const int steps = 1 + static_cast<int>(std::min(length, 4096.0));
  for (int step = 0; step <= steps; ++step) {
    const float part = static_cast<float>(step) / static_cast<float>(steps);
    const float radius = edge.parentRadius + part * (edge.childRadius - edge.parentRadius);
    if (!clip_.contains(from + part * (to - from))) continue;
    ScreenPart::Place at = part_.place(from + part * (to - from));
    if (edge.fading != Fading::whole && focus_.isPassed(at.depth)) continue;
    const double wide = 0.9 * radius / (screen_.pixelSize(at.depth) * cell); // [cells]
    at.depth -= 0.5F * radius; // its front is between its axis and one radius before it
    add(at, static_cast<int>(std::min(wide, double(largestHalf))));
  }
}

double Visibility::nearest(const Eigen::Vector2d& pixel) const {
  const QPointF corner = part_.box().topLeft();
  const Eigen::Vector2d at = (pixel - Eigen::Vector2d(corner.x(), corner.y())) / cell;
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns_ && at.y() < rows_))
    return std::numeric_limits<double>::infinity();
  return depths_[std::size_t(at.y()) * std::size_t(columns_) + std::size_t(at.x())];
}

bool Visibility::hides(const ScreenMap::Place& at, double reach) const {
  int hidden = 0;
  for (const double x : {-glyphReach, 0.0, glyphReach})
    for (const double y : {-glyphReach, 0.0, glyphReach})
      if (nearest(at.pixel + Eigen::Vector2d(x, y)) < at.depth - reach) ++hidden;
  return hidden >= mostOfNine;
}

double Visibility::reachOf(double radius, const Eigen::Vector3f& place,
                           const Eigen::Vector3f& axis) const {
  if (radius == 0 && scene_.points.size() > 0) // not measured: the nearest points are its bark
    radius = scene_.points.boxes.distance(*scene_.points.positions, place);
  const Eigen::Vector3d along = axis.cast<double>();
  const Eigen::Vector3d sight =
      screen_.isPerspective() ? (place.cast<double>() + scene_.origin() - screen_.eye()).eval()
                              : screen_.forward();
  const double size = along.norm() * sight.norm();
  const double sine = size > 0 ? along.cross(sight).norm() / size : leastSine;
  return radiusSlack * radius / std::max(sine, leastSine) + noise * scene_.points.spacing;
}

bool Visibility::hidesNode(std::size_t slot, const ScreenMap::Place& at) const {
  const NodeGlyph& node = scene_.skeleton.nodes()[slot];
  const EdgeGlyph& edge = scene_.skeleton.edges()[slot];
  const double cells = 2 * cell * screen_.pixelSize(at.depth);
  if (!hides(at, radiusSlack * double(node.radius) + cells)) return false; // the quick answer
  const Eigen::Vector3f axis = edge.shape == EdgeShape::none
                                   ? Eigen::Vector3f::Zero()
                                   : Eigen::Vector3f(Eigen::Vector3f(edge.child.data()) -
                                                     Eigen::Vector3f(edge.parent.data()));
  const double reach = reachOf(node.radius, Eigen::Vector3f(node.position.data()), axis);
  return hides(at, reach + cells);
}

bool Visibility::hidesEdge(const EdgeGlyph& edge, double fraction,
                           const ScreenMap::Place& at) const {
  const Eigen::Vector3f from(edge.parent.data());
  const Eigen::Vector3f axis = Eigen::Vector3f(edge.child.data()) - from;
  const double radius = edge.parentRadius + fraction * double(edge.childRadius - edge.parentRadius);
  const double reach = reachOf(radius, from + static_cast<float>(fraction) * axis, axis);
  return hides(at, reach + 2 * cell * screen_.pixelSize(at.depth));
}

bool Visibility::hidesPoint(const ScreenMap::Place& at) const {
  // Within a cell, a surface seen at a slant is as deep as some cells are wide.
  const double thickness = noise * scene_.points.spacing + 3 * cell * screen_.pixelSize(at.depth);
  return nearest(at.pixel) < at.depth - thickness;
}

} // namespace espalier
