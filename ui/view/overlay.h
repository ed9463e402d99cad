#pragma once

#include "ui/document/canvas.h"
#include "ui/view/attachment_overlay.h"
#include "ui/view/camera.h"
#include "ui/view/corner.h"
#include "ui/view/envelope_overlay.h"
#include "ui/view/ghost_overlay.h"
#include "ui/view/hull_overlay.h"
#include "ui/view/scene.h"
#include "ui/view/sight_overlay.h"

#include <QPainter>
#include <QPolygonF>
#include <QSizeF>
#include <QString>

#include <optional>
#include <vector>

namespace espalier {

/// The sides of a divider that are seen.
struct SeenSides {
  bool left = true;
  bool right = true;

  [[nodiscard]] static SeenSides of(double divider) { return {divider > 0, divider < 1}; }
  [[nodiscard]] bool has(Side side) const { return side == Side::left ? left : right; }
};

/// What the colors that are drawn stand for.
[[nodiscard]] std::vector<Legend> legendsOf(const Scene& scene, const QString& unit,
                                            const SeenSides& seen);

/// What is written over a side of the divider; empty: the plant, with which nothing is compared.
[[nodiscard]] QString nameOf(const Scene& scene, Side side, const SeenSides& seen);

/// What is drawn over the plant: color bar, scale bar, axes, the pivot while turning, and what
/// tools show of what they do.
struct Overlay {
  QString unit; // of lengths; empty: not known
  bool hasLegends = true;
  Corner legendsIn = Corner::topRight;
  bool isBare = false; // nothing is painted
  bool pivotShown = false;
  double divider = 1;                        // of the view, as PlantView::setDivider
  SeenSides seen = SeenSides::of(1);         // that legends are for
  std::vector<ShownHull> hulls;              // as PlantView::setHulls
  std::optional<ShownEnvelope> envelope;     // as PlantView::setEnvelope
  mutable EnvelopeGlass glass;               // of it
  std::optional<ShownSight> sight;           // as PlantView::showSight
  std::optional<ShownAttachment> attachment; // as PlantView::showAttachment
  std::vector<ShownGhost> ghosts;            // as PlantView::showGhosts
  std::optional<Eigen::Vector3d> rootMark;   // as PlantView::setRootMark
  QString word;                              // as PlantView::setWord
  QPolygonF band;                            // as Canvas::showBand
  Preview preview;                           // as Canvas::showPreview

  /// Moves the legends to the corner where they cover least of the plant, see freestCorner().
  /// @param plant as plantOnScreen()
  void giveWay(const Scene& scene, const OnScreen& plant, const QSizeF& size,
               const QFontMetricsF& font);
  /// The corners that are not free for anything else.
  [[nodiscard]] std::vector<Corner> corners() const;

  /// @param size of the view in logical pixels
  void paint(QPainter& painter, const Scene& scene, const Camera& camera, const QSizeF& size) const;
};

} // namespace espalier
