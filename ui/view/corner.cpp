#include "ui/view/corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace espalier {
namespace {

// [logical pixels]
constexpr double axesWidth = 92;
constexpr double scaleBarHeight = 40;
constexpr double coverCell = 12; // a place covers all of it

constexpr int weightOfSelected = 100; // of a cell with it: more than of much other plant

// What makes another corner clearly better.
constexpr double shareLess = 0.7; // of the cells with plant
constexpr double shareOfBox = 0.03;

/// How many cells of a box have some places behind them.
int coveredCells(const QRectF& box, const std::vector<QPointF>& places) {
  std::set<std::pair<int, int>> cells;
  for (const QPointF& place : places)
    if (box.contains(place))
      cells.emplace(static_cast<int>((place.x() - box.left()) / coverCell),
                    static_cast<int>((place.y() - box.top()) / coverCell));
  return static_cast<int>(cells.size());
}

/// Along the edges that are selected, about one place per cell, and their nodes.
void addSelected(std::vector<QPointF>& found, const SkeletonGlyphs& glyphs,
                 const ScreenMap& screen) {
  const auto isSelected = [](Mark mark) { return mark == Mark::selected || mark == Mark::both; };
  const auto at = [&](const std::array<float, 3>& place) {
    return screen.project(glyphs.origin() + Eigen::Vector3d(place[0], place[1], place[2]));
  };
  for (const NodeGlyph& node : glyphs.nodes()) {
    if (node.shape == NodeShape::none || !isSelected(node.mark)) continue;
    if (const auto place = at(node.position))
      found.emplace_back(place->pixel.x(), place->pixel.y());
  }
  for (const EdgeGlyph& edge : glyphs.edges()) {
    if (edge.shape == EdgeShape::none || !isSelected(edge.mark)) continue;
    const auto from = at(edge.parent);
    const auto to = at(edge.child);
    if (!from || !to) continue;
    const Eigen::Vector2d along = to->pixel - from->pixel;
    constexpr double most = 100; // of an edge close up
    const double steps = std::clamp(std::ceil(along.norm() / coverCell), 1.0, most);
    for (double i = 1; i < steps; ++i)
      found.emplace_back(from->pixel.x() + i / steps * along.x(),
                         from->pixel.y() + i / steps * along.y());
  }
}

void addSelectedPoints(std::vector<QPointF>& found, const Scene& scene, const ScreenMap& screen) {
  if (scene.pointStates == nullptr) return;
  const std::vector<PointState>& states = *scene.pointStates;
  constexpr std::ptrdiff_t sample = 5000;
  const std::ptrdiff_t each = 1 + std::ranges::count(states, PointState::selected) / sample;
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != PointState::selected || count++ % each != 0) continue;
    const auto column = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d place =
        scene.points.positions->col(column).cast<double>() + scene.origin();
    if (const auto at = screen.project(place)) found.emplace_back(at->pixel.x(), at->pixel.y());
  }
}

} // namespace

QRectF boxIn(Corner corner, const QSizeF& box, const QSizeF& view, double margin) {
  const double right = view.width() - box.width();
  const double bottom = view.height() - box.height();
  switch (corner) {
  case Corner::topLeft:
    return {QPointF(margin, margin), box};
  case Corner::bottomRight:
    return {QPointF(right - axesWidth, bottom - margin), box};
  case Corner::bottomLeft:
    return {QPointF(margin, bottom - margin - scaleBarHeight), box};
  case Corner::topRight:
    break;
  }
  return {QPointF(right - margin, margin), box};
}

OnScreen plantOnScreen(const Scene& scene, const ScreenMap& screen) {
  OnScreen found;
  const bool isInFocus = scene.focusDepths(screen.camera()) != FocusDepths();
  if (!isInFocus)
    for (const Eigen::Vector3d& place : scene.outline())
      if (const auto at = screen.project(place))
        found.plant.emplace_back(at->pixel.x(), at->pixel.y());
  for (const SkeletonGlyphs* glyphs : {&scene.skeleton, &scene.reference})
    addSelected(found.selected, *glyphs, screen);
  addSelectedPoints(found.selected, scene, screen);
  return found;
}

Corner freestCorner(const InCorner& it, const OnScreen& plant, const QSizeF& view,
                    const std::vector<Corner>& taken) {
  const auto isTaken = [&](Corner corner) { return std::ranges::count(taken, corner) > 0; };
  const auto covered = [&](Corner corner) {
    const QRectF box = boxIn(corner, it.box, view, it.margin);
    return coveredCells(box, plant.plant) + weightOfSelected * coveredCells(box, plant.selected);
  };
  std::optional<std::pair<int, Corner>> best; // of equals the first
  for (const Corner corner :
       {Corner::topRight, Corner::bottomRight, Corner::topLeft, Corner::bottomLeft}) {
    if (isTaken(corner)) continue;
    const int cells = covered(corner);
    if (!best || cells < best->first) best = {cells, corner};
  }
  if (!best || isTaken(it.now)) return best ? best->second : it.now;
  const int now = covered(it.now);
  const double cellsOfBox = it.box.width() * it.box.height() / (coverCell * coverCell);
  const bool isClear =
      best->first <= shareLess * now && now - best->first >= shareOfBox * cellsOfBox;
  return isClear ? best->second : it.now;
}

} // namespace espalier
