#pragma once

#include "core/base/circle_fit.h"
#include "core/radius/cross_section.h"
#include "ui/document/gesture.h"
#include "ui/document/length_unit.h"

#include <QWidget>

#include <cstdint>
#include <optional>

namespace espalier {

/// Center and radius of a node in the plane of its cross-section [L].
struct SectionNode {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0; // 0: not known
};

/// A cross-section, painted: its points, the circle of the node with handles, and the circle that
/// is proposed, dashed.
///
/// Dragging the center or the rim, or the arrow and page keys, ask for another circle; who listens
/// makes the edit and shows what came of it with setNode(). The wheel zooms, a double click shows
/// all. Edits nothing itself.
class CrossSectionView : public QWidget {
  Q_OBJECT

public:
  explicit CrossSectionView(QWidget* parent = nullptr);

  /// Shows another section, whole; with `keepView` the picture stays where it is. None: empty.
  void setSection(std::optional<CrossSection> section, bool keepView = false);
  void setNode(const SectionNode& node);
  void setProposed(const std::optional<FittedCircle>& circle);
  void setUnit(LengthUnit unit);
  void setEditable(bool isEditable); // without: no handles

  [[nodiscard]] const std::optional<CrossSection>& section() const { return section_; }
  [[nodiscard]] const SectionNode& node() const { return node_; }
  [[nodiscard]] bool isBusy() const { return dragged_ != Handle::none; } // in mid-drag
  [[nodiscard]] bool isZoomed() const { return isZoomed_; }
  [[nodiscard]] QPointF toScreen(const Eigen::Vector2d& place) const; // [L] to pixels

  [[nodiscard]] QSize sizeHint() const override { return {172, 172}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

signals:
  void circleAsked(const espalier::SectionNode& node, espalier::Gesture gesture);
  void canceled(espalier::Gesture gesture); // what the gesture asked for is not wanted
  void dragEnded();
  void pointerInside(bool isInside);

protected:
  bool event(QEvent* event) override; // keys of a drag are no shortcuts
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  enum class Handle : std::uint8_t { none, center, rim };

  [[nodiscard]] Eigen::Vector2d fromScreen(const QPointF& position) const; // [L]
  [[nodiscard]] Handle handleAt(const QPointF& position) const;
  [[nodiscard]] bool canEdit() const { return isEditable_ && section_.has_value(); }
  void showAll();
  void zoom(double factor, const QPointF& about);
  void drag(const QPointF& position);
  void endDrag(bool isKept);
  void step(const Eigen::Vector2d& shift, double factor, bool isRepeated);
  void paintPoints(QPainter& painter) const;
  void paintCircles(QPainter& painter) const;
  void paintScale(QPainter& painter) const;

  std::optional<CrossSection> section_;
  SectionNode node_;
  std::optional<FittedCircle> proposed_;
  LengthUnit unit_ = LengthUnit::unknown;
  bool isEditable_ = true;
  bool isZoomed_ = false;                            // by hand: what is shown anew keeps the scale
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero(); // of the picture [L]
  double scale_ = 1;                                 // pixels per [L]
  Handle hovered_ = Handle::none;
  Handle dragged_ = Handle::none;
  Eigen::Vector2d grabbed_ = Eigen::Vector2d::Zero(); // from the handle to the pointer [L]
  Gesture gesture_;
};

} // namespace espalier
