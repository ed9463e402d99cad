#include "ui/view/hull_overlay.h"

#include "ui/view/overlay_text.h"

#include <QPolygonF>

#include <algorithm>
#include <map>
#include <vector>

namespace espalier {
namespace {

/// The corners of a hull as they are seen; empty if one is behind the eye.
std::vector<QPointF> pixelsOf(const ConvexHull& hull, const ScreenMap& screen) {
  std::vector<QPointF> pixels;
  for (const auto& corner : hull.corners.colwise()) {
    const auto at = screen.project(corner);
    if (!at) return {};
    pixels.emplace_back(at->pixel.x(), at->pixel.y());
  }
  return pixels;
}

/// Where edges of the near side lead: from corner to corner, on one triangle each.
std::multimap<int, int> nearEdges(const ConvexHull& hull, const std::vector<QPointF>& pixels) {
  std::multimap<int, int> edges;
  for (const std::array<int, 3>& triangle : hull.triangles) {
    const auto at = [&](std::size_t i) { return pixels[static_cast<std::size_t>(triangle[i])]; };
    const QPointF a = at(1) - at(0);
    const QPointF b = at(2) - at(0);
    if (a.x() * b.y() - a.y() * b.x() >= 0) continue; // y points down: this is the far side
    for (std::size_t i = 0; i < 3; ++i)
      edges.emplace(triangle[i], triangle[(i + 1) % 3]);
  }
  return edges;
}

bool has(const std::multimap<int, int>& edges, int from, int to) {
  const auto [begin, end] = edges.equal_range(from);
  return std::any_of(begin, end, [&](const auto& edge) { return edge.second == to; });
}

/// The rim of the near side: its edges that are no edge of it when reversed.
QPolygonF outlineOf(const std::multimap<int, int>& edges, const std::vector<QPointF>& pixels) {
  std::map<int, int> rim;
  for (const auto& [from, to] : edges)
    if (!has(edges, to, from)) rim[from] = to;
  QPolygonF outline;
  if (rim.empty()) return outline;
  const int first = rim.begin()->first;
  int at = first;
  do {
    outline.append(pixels[static_cast<std::size_t>(at)]);
    const auto next = rim.find(at);
    if (next == rim.end()) break;
    at = next->second;
  } while (at != first && static_cast<std::size_t>(outline.size()) <= rim.size());
  return outline;
}

} // namespace

void paintHull(QPainter& painter, const ShownHull& shown, const ScreenMap& screen, bool dark) {
  const std::vector<QPointF> pixels = pixelsOf(shown.hull, screen);
  if (pixels.empty()) return;
  const std::multimap<int, int> edges = nearEdges(shown.hull, pixels);
  const QPolygonF outline = outlineOf(edges, pixels);
  if (outline.size() < 3) return;
  const Palette colors = palette(dark);
  painter.setPen(QPen(toQt(colors.contracted, 60), 0.75));
  for (const auto& [from, to] : edges)
    if (from < to)
      painter.drawLine(pixels[static_cast<std::size_t>(from)],
                       pixels[static_cast<std::size_t>(to)]);
  painter.setPen(QPen(toQt(colors.contracted, 230), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(toQt(colors.contracted, 36));
  painter.drawPolygon(outline);
  if (shown.label.isEmpty()) return;
  const QPointF top = *std::ranges::min_element(outline, {}, &QPointF::y);
  paintLabel(painter, top, shown.label, colors);
}

} // namespace espalier
