#pragma once

#include "ui/document/tool_input.h"
#include "ui/view/navigator.h"
#include "ui/view/scene.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <functional>
#include <optional>

namespace espalier {

/// Passes the mouse over a scene to the tools and, where they do not want it, to the camera.
class PointerInput {
public:
  using Handler = std::function<bool(const ToolInput&)>;

  /// All must outlive it.
  /// @param divider of the view, as PlantView::setDivider
  PointerInput(const Scene& scene, Navigator& navigator, const double& divider)
      : scene_(scene), navigator_(navigator), divider_(divider) {}
  /// Are nodes and edges picked, and taken by areas, that are hidden behind wood?
  void setDepth(Depth depth) { depth_ = depth; }
  [[nodiscard]] Depth depth() const { return depth_; }
  void setHandler(Handler handler) { handler_ = std::move(handler); }

  void setSize(const QSizeF& size); // [logical pixels]
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  /// Returns the place that is to become the pivot, if the click is on one and no tool took it.
  [[nodiscard]] std::optional<Eigen::Vector3d> doubleClick(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);
  void leave();
  void hoverAgain(); // after the scene changed under a resting pointer
  void cancel();     // ends what goes on; a tool undoes what it did

  /// Is a gesture of a tool or of the camera going on?
  [[nodiscard]] bool isBusy() const { return button_ != Qt::NoButton; }

  [[nodiscard]] ScreenMap screen() const;
  [[nodiscard]] Pick pick(const QPointF& position) const;
  /// What a zoom of the camera there keeps in place; the camera learns how far it may go.
  [[nodiscard]] Eigen::Vector3d zoomAnchor(const QPointF& position);

private:
  struct Pointer {
    QPointF position;
    Qt::MouseButton button;
    Qt::KeyboardModifiers modifiers;
  };
  void pickPoint(Pick& pick, const ScreenMap& map, const Eigen::Vector2d& pixel) const;
  /// Drops what is not drawn there, since another state of the plant is.
  [[nodiscard]] Pick ofPlant(const Pick& pick, const QPointF& position) const;
  [[nodiscard]] ToolInput input(ToolInput::Phase phase, const Pointer& pointer,
                                const Pick& pick) const;
  bool notify(ToolInput::Phase phase, const Pointer& pointer, const Pick& pick);
  [[nodiscard]] Eigen::Vector3d zoomAnchor(const QPointF& position, const Pick& pick) const;

  const Scene& scene_;
  Navigator& navigator_;
  const double& divider_;
  Handler handler_;
  Depth depth_ = Depth::front;
  QSizeF size_{1, 1};
  Qt::MouseButton button_ = Qt::NoButton; // which started the gesture that goes on
  bool taken_ = false;                    // by the handler
  bool cameraOnly_ = false;               // the handler is given nothing
  bool dragged_ = false;                  // farther than a click
  QPointF pressed_;                       // where
  QPointF last_;
  bool isInside_ = false; // the pointer, in the view
};

} // namespace espalier
