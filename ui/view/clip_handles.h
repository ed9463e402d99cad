#pragma once

#include "ui/view/camera.h"
#include "ui/view/clip.h"

#include <QPainter>
#include <QPointF>

#include <optional>
#include <vector>

namespace espalier {

/// What of a clip the mouse can drag in a view: the faces of the box, and on a gauge at the left of
/// the view the planes of the slab, which face the viewer, or the slab as a whole.
class ClipHandles {
public:
  struct Handle {
    enum class Part { lowFace, highFace, front, back, slab };
    Part part;
    int axis; // of a face: 0 to 2
    bool operator==(const Handle&) const = default;
  };
  /// What is looked at. Places on the screen are logical pixels.
  struct Sight {
    Clip clip;
    Eigen::AlignedBox3d bounds; // of the plant [L], frame of the file
    ScreenMap screen;
  };

  void setShown(bool isShown);
  [[nodiscard]] bool isShown() const { return isShown_; }

  /// The handle at a place; none while they are not shown, or where there is none.
  [[nodiscard]] std::optional<Handle> at(const Sight& sight, const QPointF& place) const;
  bool hover(std::optional<Handle> handle); // whether that changed anything

  /// Begins a drag; false if there is no handle.
  bool press(const Sight& sight, const QPointF& place);
  [[nodiscard]] bool isDragging() const { return drag_.has_value(); }
  /// The clip with the dragged part where the pointer is; pre: isDragging()
  [[nodiscard]] Clip drag(const Sight& sight, const QPointF& place) const;
  void release() { drag_.reset(); }
  Clip cancel(); // ends the drag; returns the clip from before it; pre: isDragging()

  void paint(QPainter& painter, const Sight& sight, bool dark) const;

private:
  struct Grip {
    Handle handle;
    QPointF place;
    QPointF direction; // on the screen, of length 1, outward
  };
  struct Drag {
    Handle handle;
    Clip before;
    double pressed; // where along its line the handle was pressed: [L], or part of the depth
  };
  [[nodiscard]] static std::vector<Grip> grips(const Sight& sight);
  static void paintBox(QPainter& painter, const Sight& sight, const QColor& color);
  void paintGauge(QPainter& painter, const Sight& sight, bool dark) const;

  bool isShown_ = false;
  std::optional<Handle> hovered_;
  std::optional<Drag> drag_;
};

} // namespace espalier
