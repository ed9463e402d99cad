#include "ui/view/target_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QCoreApplication>

namespace espalier {
namespace {

constexpr double targetRadius = 7; // [logical pixels]
constexpr double targetPen = 2;

void paintTargetRing(QPainter& painter, const QPointF& at, const Color& color,
                     const Palette& colors) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(toQt(colors.outline, 220), targetPen + 2));
  painter.drawEllipse(at, targetRadius, targetRadius);
  painter.setPen(QPen(toQt(color), targetPen));
  painter.drawEllipse(at, targetRadius, targetRadius);
}

} // namespace

void paintTargets(QPainter& painter, const ShownScan& scan, const ScreenMap& screen, bool dark) {
  const Palette colors = palette(dark);
  const auto pixelIn = [&](const std::optional<Eigen::Vector3d>& place) {
    return place ? pixelOf(screen, *place) : std::nullopt;
  };
  for (const ShownTarget& target : scan.targets) {
    const auto fixed = pixelIn(target.fixed);
    const auto moved =
        target.moved ? pixelIn(Eigen::Vector3d(scan.motion * *target.moved)) : std::nullopt;
    if (fixed && moved) {
      painter.setPen(QPen(toQt(colors.text), 1, Qt::DashLine));
      painter.drawLine(*fixed, *moved);
    }
    if (fixed) paintTargetRing(painter, *fixed, colors.fixedScan, colors);
    if (moved) paintTargetRing(painter, *moved, colors.movedScan, colors);
    const QString number = QString::number(target.number);
    const QString label =
        target.isWorst ? QCoreApplication::translate("espalier::Overlay", "%1, worst").arg(number)
                       : number;
    if (fixed || moved) paintLabel(painter, fixed ? *fixed : *moved, label, colors);
  }
}

} // namespace espalier
