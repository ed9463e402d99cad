#pragma once

#include "ui/view/corner.h"
#include "ui/view/scene.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

namespace espalier {

/// All of the plant in a corner of a view, seen from the same direction, with a frame of what the
/// view shows. A click or drag in it asks for the camera to be moved there.
class Minimap : public QWidget {
  Q_OBJECT

public:
  /// @param scene must outlive it
  Minimap(const Scene& scene, QWidget* view);

  /// Does it fit in a view of this size, beside what else is there?
  [[nodiscard]] static bool fits(const QSize& view);
  void place(const QSize& view); // in its corner
  /// Goes to the corner where it covers least of the plant, see freestCorner().
  void giveWay(const OnScreen& plant, const QSize& view, const std::vector<Corner>& taken);

  void noteChange(); // of the plant or its colors: drawn anew a moment later
  void showCamera(const Camera& camera);
  [[nodiscard]] bool showsMore() const; // of the plant than the view does

  [[nodiscard]] bool isDragging() const { return held_.has_value(); }
  void cancel(); // asks for the camera to be put back; pre: isDragging()

signals:
  void drawnAnew();                             // after noteChange()
  void moveAsked(const Eigen::Vector3d& focus); // [L]
  void canceled(const espalier::Camera& before);
  void entered(); // the pointer is no longer over the plant

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void enterEvent(QEnterEvent* event) override;

private:
  void frameAll(); // aims map_ at all of the plant
  void drawPlant();
  [[nodiscard]] ScreenMap screen() const;
  [[nodiscard]] std::optional<QPointF> pixelOf(const Eigen::Vector3d& place) const;
  /// What the view shows at the depth of its focus.
  [[nodiscard]] QRectF frame() const;
  void moveTo(const QPointF& place);

  const Scene& scene_;
  Corner corner_ = Corner::bottomRight;
  std::vector<Eigen::Vector3d> places_; // of the plant [L]
  Camera camera_;                       // of the view
  Camera map_;                          // of the map
  double viewAspect_ = 1;               // width of the view over its height
  QImage plant_;                        // null: to be drawn anew
  QTimer later_;
  std::optional<QPointF> held_; // in a drag: from the middle of the frame to the pointer
  Camera before_;               // the drag, of the view
};

} // namespace espalier
