#include "ui/view/area.h"

#include <QImage>
#include <QPainter>

namespace espalier {
namespace {

/// An area as a picture of its pixels: whether a point is in it takes no longer the more corners
/// it has. To a pixel.
class AreaMask {
public:
  explicit AreaMask(const QPolygonF& area, const QRect& within)
      : box_(area.boundingRect().toAlignedRect().adjusted(-1, -1, 1, 1) & within) {
    if (box_.isEmpty()) return;
    image_ = QImage(box_.size(), QImage::Format_Grayscale8);
    image_.fill(0);
    QPainter painter(&image_);
    painter.translate(-box_.topLeft());
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPolygon(area, Qt::WindingFill);
  }

  [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const {
    const double x = pixel.x() - box_.left();
    const double y = pixel.y() - box_.top();
    if (!(x >= 0 && y >= 0 && x < image_.width() && y < image_.height())) return false;
    return image_.constScanLine(static_cast<int>(y))[static_cast<int>(x)] != 0;
  }

private:
  QRect box_;
  QImage image_;
};

} // namespace

std::vector<NodeId> nodesInside(const Scene& scene, const ScreenMap& screen, const QPolygonF& area,
                                Depth /*depth*/) {
  std::vector<NodeId> found;
  if (!scene.skeletonVisible) return found;
  const QRectF box = area.boundingRect();
  for (std::size_t slot = 0; slot < scene.skeleton.nodes().size(); ++slot) {
    if (scene.skeleton.nodes()[slot].shape == NodeShape::none) continue;
    const auto at = screen.project(scene.skeleton.position(slot));
    if (!at) continue;
    const QPointF pixel(at->pixel.x(), at->pixel.y());
    if (box.contains(pixel) && area.containsPoint(pixel, Qt::WindingFill))
      found.push_back(NodeId{static_cast<std::uint32_t>(slot)});
  }
  return found;
}

std::vector<Eigen::Index> pointsInside(const Scene& scene, const ScreenMap& screen,
                                       const QPolygonF& area, Depth /*depth*/) {
  std::vector<Eigen::Index> found;
  if (!scene.points.visible || scene.points.size() == 0) return found;
  const AreaMask mask(area, QRect(QPoint(0, 0), QSize(16384, 16384)));
  const Eigen::Vector3d origin = scene.origin();
  for (Eigen::Index i = 0; i < scene.points.size(); ++i) {
    const auto at = screen.project(scene.points.positions->col(i).cast<double>() + origin);
    if (at && mask.contains(at->pixel)) found.push_back(i);
  }
  return found;
}

} // namespace espalier
