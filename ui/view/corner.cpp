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

// What makes another corner clearly better.
constexpr double shareLess = 0.7; // of the cells with plant
constexpr double shareOfBox = 0.03;

/// How many cells of a box have plant behind them.
int coveredCells(const QRectF& box, const std::vector<QPointF>& plant) {
  std::set<std::pair<int, int>> cells;
  for (const QPointF& place : plant)
    if (box.contains(place))
      cells.emplace(static_cast<int>((place.x() - box.left()) / coverCell),
                    static_cast<int>((place.y() - box.top()) / coverCell));
  return static_cast<int>(cells.size());
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

std::vector<QPointF> plantOnScreen(const Scene& scene, const ScreenMap& screen) {
  std::vector<QPointF> found;
  for (const Eigen::Vector3d& place : scene.outline())
    if (const auto at = screen.project(place)) found.emplace_back(at->pixel.x(), at->pixel.y());
  return found;
}

Corner freestCorner(const InCorner& it, const std::vector<QPointF>& plant, const QSizeF& view,
                    const std::vector<Corner>& taken) {
  const auto isTaken = [&](Corner corner) { return std::ranges::count(taken, corner) > 0; };
  const auto covered = [&](Corner corner) {
    return coveredCells(boxIn(corner, it.box, view, it.margin), plant);
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
