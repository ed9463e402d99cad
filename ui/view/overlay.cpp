#include "ui/view/overlay.h"

#include "ui/document/number_scale.h"
#include "ui/view/legend.h"
#include "ui/view/overlay_of_tools.h"
#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"
#include "ui/view/target_overlay.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr double overlayMargin = 16; // [logical pixels], as all below

QString withUnit(const QString& text, const QString& unit) {
  return unit.isEmpty() ? text : text + QChar::Nbsp + unit;
}

void paintScaleBar(QPainter& painter, const Scene& scene, const Camera& camera, const QString& unit,
                   const QSizeF& size) {
  const Palette colors = palette(scene.dark);
  const double pixel = camera.halfHeight() / (size.height() / 2);
  const double length = roundStep(140 * pixel);
  const QPointF left(overlayMargin, size.height() - overlayMargin);
  const QPointF right = left + QPointF(length / pixel, 0);
  paintVeil(painter, QRectF(left + QPointF(-8, -28), right + QPointF(8, 8)),
            colors.backgroundBottom);
  painter.setPen(QPen(toQt(colors.text), 1.5));
  painter.drawLine(left, right);
  for (const QPointF& end : {left, right})
    painter.drawLine(end + QPointF(0, -4), end);
  const QRectF box(left.x(), left.y() - 24, std::max(right.x() - left.x(), 80.0), 18);
  drawText(painter, box, Qt::AlignLeft | Qt::AlignVCenter,
           withUnit(numberAtStep(length, length), unit), colors);
}

void paintAxes(QPainter& painter, const Camera& camera, const QSizeF& size, bool dark) {
  constexpr double reach = 26;
  const QPointF middle(size.width() - overlayMargin - reach - 10,
                       size.height() - overlayMargin - reach - 10);
  const QPointF corner(reach + 16, reach + 16);
  paintVeil(painter, QRectF(middle - corner, middle + corner), palette(dark).backgroundBottom);
  struct Axis {
    Eigen::Vector3d direction;
    QString name;
    QColor color;
  };
  std::array<Axis, 3> axes{
      {{Eigen::Vector3d::UnitX(), QStringLiteral("x"), QColor(0xcc, 0x4b, 0x4b)},
       {Eigen::Vector3d::UnitY(), QStringLiteral("y"), QColor(0x3f, 0x9a, 0x5f)},
       {Eigen::Vector3d::UnitZ(), QStringLiteral("z"), QColor(0x4a, 0x7f, 0xd0)}}};
  const Eigen::Vector3d forward = camera.forward();
  std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) { // the nearest last
    return a.direction.dot(forward) > b.direction.dot(forward);
  });
  for (const Axis& axis : axes) {
    const QPointF along(axis.direction.dot(camera.right()), -axis.direction.dot(camera.up()));
    const double depth = axis.direction.dot(forward);
    QColor color = axis.color;
    color.setAlphaF(static_cast<float>(0.75 - 0.25 * depth));
    painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle, middle + reach * along);
    if (std::abs(depth) > 0.95) continue; // its name would stand on the others'
    const QPointF place = middle + (reach + 8) * along;
    painter.drawText(QRectF(place.x() - 8, place.y() - 8, 16, 16), Qt::AlignCenter, axis.name);
  }
}

void paintPivot(QPainter& painter, const Scene& scene, const Camera& camera, const QSizeF& size) {
  const ScreenMap map(camera, {size.width(), size.height()});
  const auto pivot = map.project(camera.pivot);
  if (!pivot) return;
  const QPointF place(pivot->pixel.x(), pivot->pixel.y());
  const Palette colors = palette(scene.dark);
  painter.setBrush(Qt::NoBrush);
  // Flattened as a level ring around the pivot would be seen.
  const double flat = std::max(0.08, std::abs(std::sin(camera.pitch)));
  for (const QPen& pen :
       {QPen(toQt(colors.backgroundBottom, 200), 4.5), QPen(toQt(colors.contracted), 2)}) {
    painter.setPen(pen);
    painter.drawEllipse(place, 18, 18 * flat);
    painter.drawLine(place - QPointF(0, 12), place + QPointF(0, 12));
  }
}

/// What is said in the middle of a view that shows nothing.
void paintWord(QPainter& painter, const QString& word, bool dark, const QSizeF& size) {
  if (word.isEmpty()) return;
  const QRectF room = QRectF(QPointF(0, 0), size)
                          .adjusted(overlayMargin, overlayMargin, -overlayMargin, -overlayMargin);
  drawText(painter, room, Qt::AlignCenter | Qt::TextWordWrap, word, palette(dark));
}

/// Where another state of the plant is shown only in a ball: its outline.
void paintBalls(QPainter& painter, const Scene& scene, double divider, const ScreenMap& screen) {
  for (const Side side : {Side::left, Side::right}) {
    const OtherState& other = scene.other(side);
    if (!other.isShown || !other.within || !SeenSides::of(divider).has(side)) continue;
    const auto middle = screen.project(other.within->center);
    if (!middle) continue;
    const double radius = other.within->radius / screen.pixelSize(middle->depth);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQt(palette(scene.dark).contracted, 160), 1.5, Qt::DashLine));
    painter.drawEllipse(QPointF(middle->pixel.x(), middle->pixel.y()), radius, radius);
  }
}

/// From where to where the top of the view is free of legends [logical pixels].
std::pair<double, double> freeAtTop(const std::vector<LegendBox>& legends, Corner corner,
                                    const QSizeF& size) {
  std::pair<double, double> free(0, size.width());
  for (const LegendBox& legend : legends) {
    if (corner == Corner::topLeft) free.first = std::max(free.first, legend.veil.right());
    if (corner == Corner::topRight) free.second = std::min(free.second, legend.veil.left());
  }
  return free;
}

/// What is seen on each side of the divider, at its top, from where to where that is free.
void paintStateNames(QPainter& painter, const Scene& scene, double divider, const SeenSides& seen,
                     const QSizeF& size, const std::pair<double, double>& free) {
  const Palette colors = palette(scene.dark);
  const double x = divider * size.width();
  const QFontMetricsF metrics(painter.font());
  for (const Side side : {Side::left, Side::right}) {
    const QString name = nameOf(scene, side, seen);
    const bool isLeft = side == Side::left;
    const double from = isLeft ? free.first : std::max(x, free.first);
    const double to = isLeft ? std::min(x, free.second) : free.second;
    if (name.isEmpty() || to - from < 4 * overlayMargin) continue;
    const bool isAlone = isLeft ? divider >= 1 : divider <= 0;
    const QString text = metrics.elidedText(name, Qt::ElideRight, to - from - 2 * overlayMargin);
    const double width = metrics.horizontalAdvance(text);
    const double middle = std::max(from + overlayMargin + width / 2,
                                   std::min(size.width() / 2, to - overlayMargin - width / 2));
    const double left = isAlone  ? middle - width / 2
                        : isLeft ? to - overlayMargin - width
                                 : from + overlayMargin;
    const QRectF box(left, overlayMargin, width, metrics.height());
    paintVeil(painter, box.adjusted(-8, -4, 8, 4), colors.backgroundBottom);
    drawText(painter, box, Qt::AlignCenter, text, colors);
  }
}

bool showsPlantBeside(const OtherState& other) {
  return !other.isShown || other.within.has_value();
}

/// Is there a side of the divider where this can be said of the other state?
bool isSeen(const Scene& scene, const SeenSides& seen, bool (*what)(const OtherState&)) {
  return std::ranges::any_of(std::array{Side::left, Side::right},
                             [&](Side side) { return seen.has(side) && what(scene.other(side)); });
}

/// Contracted points that are shown in place of the others have one color, except while they move.
bool areColorsOfPointsSeen(const Scene& scene, const SeenSides& seen) {
  return scene.blend || scene.pointValues || isSeen(scene, seen, [](const OtherState& other) {
           return showsPlantBeside(other) || !other.replacesPoints;
         });
}

} // namespace

std::vector<Legend> legendsOf(const Scene& scene, const QString& unit, const SeenSides& seen) {
  std::vector<Legend> legends;
  const auto add = [&](const std::optional<Legend>& legend) { // what several share, once
    if (legend && !std::ranges::count(legends, *legend)) legends.push_back(*legend);
  };
  if (scene.moved.isShown()) { // which has the open scan in one color
    add(scene.movedLegend());
  } else if (scene.points.visible && areColorsOfPointsSeen(scene, seen)) {
    add(scene.pointLegend());
    const bool isHeight = !scene.pointValues && scene.pointColor == PointColor::height;
    if (isHeight && !legends.empty()) legends.back().unit = unit;
  }
  if (scene.skeletonVisible && isSeen(scene, seen, showsPlantBeside)) add(scene.nodeLegend());
  for (const Side side : {Side::left, Side::right})
    if (scene.skeletonVisible && seen.has(side) && scene.other(side).isShown)
      add(scene.legendOf(scene.other(side)));
  if (scene.referenceVisible) add(scene.referenceLegend());
  return legends;
}

QString nameOf(const Scene& scene, Side side, const SeenSides& seen) {
  if (scene.other(side).isShown) return scene.other(side).name;
  const Side opposite = side == Side::left ? Side::right : Side::left;
  const bool isCompared = seen.has(opposite) && scene.other(opposite).isShown;
  return isCompared ? QCoreApplication::translate("espalier::Overlay", "Plant") : QString();
}

void Overlay::giveWay(const Scene& scene, const OnScreen& plant, const QSizeF& size,
                      const QFontMetricsF& font) {
  const std::vector<Legend> legends =
      hasLegends ? legendsOf(scene, unit, seen) : std::vector<Legend>();
  if (legends.empty()) return;
  std::vector<Corner> taken;
  if (sight) taken.push_back(Corner::topLeft); // by its key
  legendsIn = freestCorner(legendsInCorner(legends, size, font, legendsIn), plant, size, taken);
}

std::vector<Corner> Overlay::corners() const {
  std::vector<Corner> corners;
  if (hasLegends) corners.push_back(legendsIn);
  if (sight && hasLegends) corners.push_back(Corner::topLeft);
  return corners;
}

void Overlay::paint(QPainter& painter, const Scene& scene, const Camera& camera,
                    const QSizeF& size) const {
  if (isBare) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const ScreenMap screen(camera, {size.width(), size.height()});
  for (const ShownHull& hull : hulls)
    paintHull(painter, hull, screen, scene.dark);
  if (envelope) glass.paint(painter, *envelope, screen, scene.dark);
  if (sight) paintSight(painter, *sight, screen, scene.dark);
  if (attachment && scene.referenceVisible)
    paintAttachment(painter, *attachment, screen, scene.dark);
  paintBalls(painter, scene, divider, screen);
  if (scene.moved.isShown()) paintTargets(painter, scene.moved.shown, screen, scene.dark);
  if (rootMark) paintRootMark(painter, *rootMark, screen, scene.dark);
  paintGhosts(painter, ghosts, screen, scene.dark);
  paintPreview(painter, preview, screen, scene.dark);
  paintBand(painter, band, scene.dark);
  if (scene.bounds().isEmpty()) return;
  const std::vector<Legend> legends =
      hasLegends ? legendsOf(scene, unit, seen) : std::vector<Legend>();
  paintLegends(painter, legends, size, legendsIn, scene.dark);
  paintScaleBar(painter, scene, camera, unit, size);
  paintAxes(painter, camera, size, scene.dark);
  if (pivotShown) paintPivot(painter, scene, camera, size);
  paintWord(painter, word, scene.dark, size);
  paintStateNames(painter, scene, divider, seen, size,
                  freeAtTop(legendBoxes(legends, size,
                                        QFontMetricsF(painter.font(), painter.device()), legendsIn),
                            legendsIn, size));
  if (sight && hasLegends) paintSightKey(painter, *sight, scene.dark);
}

} // namespace espalier
