#pragma once

#include "core/surface/surface_mesh.h"
#include "ui/view/camera.h"

#include <QImage>
#include <QPainter>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// A place of an envelope that the mouse drags [L], frame of the file.
struct ShownHandle {
  QString label;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();     // of length 1: it moves along this
  Eigen::Vector3d outward = Eigen::Vector3d::Zero(); // and this, if it is not zero; level
  bool isFree = false;                               // it moves as the pointer does
};

/// A closed surface about the crown, what is written at its top, and what of it can be dragged.
struct ShownEnvelope {
  std::shared_ptr<const SurfaceMesh> mesh;
  QString label;
  std::vector<ShownHandle> handles = {};
};

/// Paints envelopes as glass, over the plant that is in them: the more so where the surface turns
/// away from the eye. Nothing of one that reaches behind the eye. Keeps the last picture.
class EnvelopeGlass {
public:
  void paint(QPainter& painter, const ShownEnvelope& envelope, const ScreenMap& screen, bool dark);

private:
  void draw(const SurfaceMesh& mesh, const ScreenMap& screen, bool dark);

  std::shared_ptr<const SurfaceMesh> mesh_; // that the picture is of
  std::optional<Camera> camera_;
  Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
  bool dark_ = false;
  QImage image_; // null: nothing is seen
  QPointF corner_;
  QPointF top_;
};

/// The handles of an envelope in one view: which is under the pointer, or dragged.
class EnvelopeHandles {
public:
  using Handles = std::vector<ShownHandle>;

  /// The handle at a place on the screen, if there is one.
  [[nodiscard]] static std::optional<std::size_t> at(const Handles& handles,
                                                     const ScreenMap& screen, const QPointF& place);
  bool hover(std::optional<std::size_t> handle); // whether that changed anything

  bool press(const Handles& handles, const ScreenMap& screen, const QPointF& place);
  [[nodiscard]] std::optional<std::size_t> dragged() const { return dragged_; }
  /// Where the dragged handle is pulled to [L]. pre: dragged()
  [[nodiscard]] Eigen::Vector3d drag(const Handles& handles, const ScreenMap& screen,
                                     const QPointF& place) const;
  void release() { dragged_.reset(); }

  void paint(QPainter& painter, const Handles& handles, const ScreenMap& screen, bool dark) const;

private:
  std::optional<std::size_t> hovered_;
  std::optional<std::size_t> dragged_;
  QPointF grip_; // from the pointer to the middle of the handle when it was pressed
};

} // namespace espalier
